// SVG path data ("M 10 10 C ..."), as in the attribute `d` of a path (SVG 1.1, section 8.3).
#pragma once

#include "core/formats/result.h"
#include "core/spline/curve.h"

#include <string_view>
#include <vector>

namespace splineloft {

/// The subpaths of path data as curves, y down as in the file: of straight lines only as `linear`,
/// others as `bezier-spline`; arcs as cubics (W3C, SVG 1.1, appendix F.6). A subpath that ends in Z
/// is closed and does not repeat its first point. The place of a refusal is the byte, from 0.
Result<std::vector<Curve>> curvesFromPathData(std::string_view data);

} // namespace splineloft
