// Families that pass through the joints with tangents by a rule: the joints, with all that a rule
// may look at, and the curve through them.
#pragma once

#include "core/spline/change/trial.h"

#include <optional>
#include <vector>

namespace splineloft::conversion {

/// A joint with the chords around it. Outside an open curve there is only a chord where the ends
/// are doubled or reflected.
struct Corner {
    std::optional<Point> before, after;     ///< chords
    std::optional<Point> arriving, leaving; ///< tangents, where a piece has them
};

/// The corners at all joints, with the chords that such ends make.
std::vector<Corner> cornersOf(const Shape& shape, Ends ends);

/// The curve through the joints; open ends get the points that `outside` finds for the corner.
template <class Outside>
Curve throughJoints(const Shape& shape, const Trial& trial, Ends ends, Outside outside) {
    Curve curve = trial.blank();
    const bool open = !shape.closed && ends == Ends::open;
    if (!shape.closed) {
        curve.ends = ends;
    }
    if (open) {
        curve.points.append(outside(std::size_t{0}));
    }
    for (std::size_t i = 0; i < shape.joints(); ++i) {
        curve.points.append(shape.joint(i));
    }
    if (open) {
        curve.points.append(outside(shape.size()));
    }
    return curve;
}

/// One value a control point, of which open ends have one more at either end.
std::vector<double> atPoints(std::vector<double> atJoints, const Curve& curve, double neutral);

/// The ends to try, those with the fewest points first.
std::vector<Ends> waysToEnd(const Shape& shape);

} // namespace splineloft::conversion
