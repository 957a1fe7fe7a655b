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
};

/// The displacement along the nearest of the two axes and the two lines at 45 degrees.
SnappedMove onCourse(double dx, double dy);

/// The displacement that puts `grabbed` onto the nearest control point not among `ids` within
/// reach, otherwise onto the nearest fine grid point.
SnappedMove snapped(const SnappedMove& move, const std::vector<PointId>& ids,
                    const PointId& grabbed, const View& view, const Situation& situation);

/// The displacement that puts `grabbed` on a decimal that one pixel can tell apart, so that
/// coordinates stay as short as a hand is exact.
SnappedMove tidied(const SnappedMove& move, const PointId& grabbed, const View& view,
                   const Situation& situation);

/// The same for a place.
PlanePoint tidied(PlanePoint place, const Camera& camera);

} // namespace splineloft::ui
