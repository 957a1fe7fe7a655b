// The grid behind the curves: fine lines, coarse lines with numbers, the axes.
#pragma once

#include "ui/canvas/scene.h"
#include "ui/canvas/viewport.h"

namespace splineloft::ui {

/// Distance of the fine lines in units: the step that Ctrl snaps to.
double fineGridStep(const Camera& camera, double scale);

/// Adds the grid; its numbers stand along the left and lower edge.
void drawGrid(Scene& scene, const Viewport& viewport, double scale);
void drawGridNumbers(Scene& scene, const Viewport& viewport, double scale);

} // namespace splineloft::ui
