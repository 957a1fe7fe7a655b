// The peers: each adds its entries, called as its own users would. One is compiled where CMake
// found its package.
#pragma once

#include "tests/bench/contest.h"

namespace splineloft::bench {

void addGlm(Contest& contest);
void addEigen(Contest& contest);
void addGsl(Contest& contest);
void addBoost(Contest& contest);
void addSisl(Contest& contest);
void addLib2geom(Contest& contest);

} // namespace splineloft::bench
