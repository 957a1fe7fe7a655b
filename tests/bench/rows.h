// The rows of the table, in groups: each adds its rows and our own entries.
#pragma once

#include "tests/bench/contest.h"

namespace splineloft::bench {

void addDense(Contest& contest);
void addLarge(Contest& contest);
void addRandom(Contest& contest);
void addHighDegree(Contest& contest);
void addNatural(Contest& contest);
void addLength(Contest& contest);
void addEven(Contest& contest);
void addNearest(Contest& contest);
void addBSpline(Contest& contest);
void addJets(Contest& contest);

} // namespace splineloft::bench
