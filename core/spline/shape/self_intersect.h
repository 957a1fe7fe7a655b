// Where a plane curve crosses itself.
#pragma once

#include "core/spline/piece.h"

#include <cstddef>
#include <vector>

namespace splineloft {

/// One place that a curve passes twice.
struct SelfCrossing {
    /// The earlier and the later spot. A joint within rounding is the start of the piece after it
    /// that gets anywhere; the end of a curve that ends where it starts is its start, {0, 0}.
    Spot a, b;
    Point place;
};

/// All such places, each once, in the order of `a`, then `b`.
struct SelfCrossings {
    std::vector<SelfCrossing> crossings;
    /// Whether these are all. Not so where stretches of the curve coincide within rounding, of
    /// which no place is named, ends included; where branches touch with curvatures that hardly
    /// differ, or within about a thousandth of a piece from where x or y stands still, so that
    /// rounding may hide how often they meet; where there are more than `most`; and where the
    /// search was given up, after a few seconds' work.
    bool complete = true;
};

/// The self-intersections of a plane curve (curves of other dimensions have none). Where the two
/// branches cross at an angle the spots are exact to about 1e-12 of their curve's size; where they
/// only touch, to about 1e-7, and touches are found only where the branches come within rounding of
/// each other. The joint between two pieces is no crossing, nor is the
/// start of a curve that ends where it starts; a place that three branches pass comes up once for
/// every two of them.
///
/// Usually O(n log n) in the number of pieces, and in that of pairs of stretches whose boxes
/// overlap. Bounded work: stretches that coincide are told at once from their ends and some places
/// between, and after more than twice the work that 100'000 crossings at an angle take, the search
/// is given up.
///
/// The curve is split where x or y stands still, so that no stretch can cross itself; stretches
/// whose boxes overlap are halved until they part, or until the directions that they run in do,
/// after which they cross once at most (Sederberg and Meyers 1988) and Newton's steps find it.
SelfCrossings selfIntersections(const Pieces& pieces, std::size_t most = 100'000);

} // namespace splineloft
