// Where a curve crosses a line, a plane, or in general a hyperplane.
#pragma once

#include "core/spline/piece.h"

#include <optional>
#include <vector>

namespace splineloft {

/// The places x with normal . (x - place) = 0: a line in the plane, a plane in space. Given by a
/// place, and not by its distance from the origin, so that it is as exact far away from there.
struct Hyperplane {
    Point place;
    Point normal; ///< of any length but zero
};

/// The line through two places of the plane; its normal is a unit vector to the left of the way
/// from `a` to `b`. Nothing where they are the same or not in the plane.
std::optional<Hyperplane> lineThrough(const Point& a, const Point& b);

/// What a curve and a hyperplane have in common.
struct Crossings {
    /// The spots in order: crossings and touches alike. A joint counts once, as the start of the
    /// later piece, and so does the start of a curve that ends where it starts.
    std::vector<Spot> spots;
    /// Pieces that lie in the hyperplane with all their Bézier points, within rounding. They have
    /// no spots of their own; the pieces before and after them end in one.
    std::vector<std::size_t> within;
};

/// The crossings of a curve of any dimension: zeros of the distance from the hyperplane, which is a
/// Bernstein polynomial on every piece (times the weight on rational ones). None where the
/// hyperplane is of another dimension or not finite, or its normal is zero. O(pieces).
Crossings crossings(const Pieces& pieces, const Hyperplane& hyperplane);

} // namespace splineloft
