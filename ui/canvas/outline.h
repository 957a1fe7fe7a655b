// Bézier pieces as lines on the screen, as fine as the screen can show and no finer.
#pragma once

#include "ui/canvas/viewport.h"

#include <vector>

namespace splineloft::ui {

/// How far the segments that stand for a curve may be from it, in pixels.
inline constexpr double lineFlatness = 0.1;
/// How far around the frame lines may still be seen, in pixels.
inline constexpr double lineOverhang = 40;

/// The part of a plane curve that matters in a viewport, as polylines within a tenth of a pixel of
/// it. Each piece is halved until it is flat or lies wholly outside; pieces follow one another
/// without a break. Crisp at any zoom, with bounded work.
std::vector<ScreenPoint> outline(const Pieces& plane, const Viewport& viewport);

} // namespace splineloft::ui
