// How far two curves are apart, whatever their parameters.
#pragma once

#include "core/spline/piece.h"

namespace splineloft::testing_curves {

/// The farthest that samples of the one curve are from the other, both ways.
double farthestApart(const Pieces& one, const Pieces& other);

/// The farthest that samples of `one` are from `other`.
double farthestFrom(const Pieces& one, const Pieces& other);

} // namespace splineloft::testing_curves
