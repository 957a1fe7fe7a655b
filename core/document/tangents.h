// Tangents for points that come without any.
#pragma once

#include "core/spline/point.h"

namespace splineloft {

/// Half of the chord from the point before to the point after, at each point.
Points catmullRomTangents(const Points& points, bool closed);

} // namespace splineloft
