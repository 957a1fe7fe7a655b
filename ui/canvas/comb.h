// The curvature comb: how strongly a curve bends, all along it.
#pragma once

#include "ui/canvas/scene.h"
#include "ui/canvas/viewport.h"
#include "ui/study.h"

namespace splineloft::ui {

/// Adds teeth square to the curve, as long as the curvature; the mean has the usual length.
void drawComb(Scene& scene, const Study& study, const Axes& axes, const Viewport& viewport,
              double scale);

} // namespace splineloft::ui
