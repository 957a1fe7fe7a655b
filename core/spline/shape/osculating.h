// The osculating circle: the one that touches a curve most closely at a spot.
#pragma once

#include "core/spline/piece.h"

#include <optional>

namespace splineloft {

/// The circle and the two directions of its plane.
struct OsculatingCircle {
    Point center;
    Point tangent; ///< unit vector, the way the curve runs
    Point normal;  ///< unit vector from the curve toward the center, square to the tangent
    double radius = 0;
};

/// The osculating circle at a spot, in the space of the curve whatever its dimension: its center
/// lies 1 / curvature from the spot along the normal (Leibniz 1686). Nothing where there is no such
/// circle: where the speed is zero, where the curvature is zero or cannot be told from zero among
/// the rounding of the coordinates, and where the center is too far away for a number.
std::optional<OsculatingCircle> osculatingCircle(const Pieces& pieces, Spot spot);

} // namespace splineloft
