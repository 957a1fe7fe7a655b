// What is left of a curve, moved nearer to the whole: two ways, for Bézier splines and for the
// other families. Neither promises that it helps; who calls them measures that.
#pragma once

#include "core/document/document.h"

#include <set>
#include <vector>

namespace splineloft {

/// The Bézier spline `left`, which is `old` without the anchors `gone`, with handles of the pieces
/// that bridge a gap that have the lengths with which they come nearest to what was there; their
/// directions stay (least squares, as in Schneider 1990). Automatic anchors beside a gap are no
/// longer that.
CurveEntry withFittedHandles(const Curve& old, const CurveEntry& left,
                             const std::set<std::size_t>& gone);

/// The curve `left`, which is `old` without the control points `gone`, with a few control points on
/// either side of each gap moved so that places at corresponding parameter values come together:
/// least squares, linear since the curve is a blend of its points. Of a Hermite curve the tangents
/// beside a gap change instead. The ends of an open curve stay.
Curve withFittedPoints(const Curve& old, const Curve& left, const std::set<std::size_t>& gone);

} // namespace splineloft
