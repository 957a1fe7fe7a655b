// Elliptical arcs of SVG paths as cubics.
#pragma once

#include "core/document/plane_map.h"

#include <array>
#include <vector>

namespace splineloft {

/// An arc as path data give it: from its start to its end.
struct SvgArc {
    PlanePlace start, end;
    double radiusX = 1, radiusY = 1; ///< not zero: that would be a straight line
    double rotation = 0;             ///< of the ellipse's x axis, in degrees
    bool isLarge = false, sweeps = false;
};

/// Two handles and the end of a cubic.
using CubicTo = std::array<PlanePlace, 3>;

/// Cubics of at most a quarter turn each, within 3e-4 of the radius of the arc (Goldapp 1991).
/// Radii too small to reach from the start to the end are scaled up until they do (SVG 1.1,
/// appendix F.6). None where the arc ends at its start.
std::vector<CubicTo> cubicsOf(const SvgArc& arc);

} // namespace splineloft
