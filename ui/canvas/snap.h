// Snapping: the grabbed point goes to a point of the document or of the grid that is near it.
#pragma once

#include "ui/canvas/gesture.h"

#include <optional>

namespace splineloft::ui {

/// A displacement in the plane, what it keeps to and what it snapped to.
struct SnappedMove {
    double dx = 0, dy = 0;
    Course course = Course::free;
    std::optional<PlanePoint> to = std::nullopt;

    PlanePoint from(PlanePoint start) const { return {start.x + dx, start.y + dy}; }
};

/// The displacement along the nearest of the two axes and the two lines at 45 degrees.
SnappedMove onCourse(double dx, double dy);

/// The displacement of something at `start` by (dx, dy), as the keys held bend it. With Shift it
/// keeps to a course. With Control it ends on the nearest control point not among `ids` within
/// reach, otherwise on the nearest fine grid point; without, on decimals that one pixel can tell
/// apart, so that coordinates stay as short as a hand is exact.
SnappedMove steered(double dx, double dy, PlanePoint start, const Modifiers& modifiers,
                    const std::vector<PointId>& ids, const View& view, const Situation& situation);

/// A place on such decimals.
PlanePoint tidied(PlanePoint place, const Camera& camera);

} // namespace splineloft::ui
