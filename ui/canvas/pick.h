// What lies under the pointer.
#pragma once

#include "ui/canvas/viewport.h"
#include "ui/study.h"

#include <optional>
#include <vector>

namespace splineloft::ui {

/// How far from a thing the pointer may be, design pixels.
inline constexpr double pointReach = 10;
inline constexpr double curveReach = 7;

/// What was hit: a control point or tangent first, otherwise a curve.
struct Hit {
    std::optional<PointId> point;
    std::optional<CurveHit> curve;
};

/// Looks under `at`, at the curves that hands may touch. Where things lie on top of one another the
/// selected one wins, then one of the active curve, then the nearest, then the one drawn on top.
Hit pick(const Document& document, const Studies& studies, const View& view,
         const Viewport& viewport, ScreenPoint at, double scale);

/// All control points and tangents within reach of `at`, in the order of the document: more than
/// one where they lie on top of one another.
std::vector<PointId> pointsUnder(const Document& document, const Studies& studies, const View& view,
                                 const Viewport& viewport, ScreenPoint at, double scale);

/// All control points (not tangents) inside a rectangle, of the curves that hands may touch.
Selection pointsInside(const Document& document, const Studies& studies, const View& view,
                       const Viewport& viewport, const ScreenRect& rect);

} // namespace splineloft::ui
