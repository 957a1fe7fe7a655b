// The lists that accompany a curve's points (weights, local parameters, knots), kept in step with
// them. Tangents have their own rules and are not touched here.
#pragma once

#include "core/spline/curve.h"

#include <cstddef>
#include <set>

namespace splineloft {

/// Makes room for the control point that was inserted as number `index`: it gets the mean weight
/// and local parameters of its neighbours, and a B-spline with knots of its own one more knot in
/// the middle of an interval there. A spline too short for any interval gives its knots up.
void addToLists(Curve& curve, std::size_t index);

/// Takes the entries of control points away that were deleted, with a knot for each of them.
void removeFromLists(Curve& curve, const std::set<std::size_t>& indices);

/// Gives up the knots of one's own, for the first of the family's ways of ending.
void dropKnots(Curve& curve);

/// Gives up every list that the curve's family does not use.
void dropUnusedLists(Curve& curve);

} // namespace splineloft
