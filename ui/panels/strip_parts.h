// What the strip of plots is put together from: its controls above the plots, the numbers beside
// them.
#pragma once

#include "ui/canvas/motion_plot.h"
#include "ui/stage.h"

namespace splineloft::ui {

/// Play and pause, pace, duration and beads; at the right which plot to show.
void drawTransport(View& view, const Stage& stage);

/// Each control's share at the cursor, and their sum.
void drawWeights(const Study& study, const View& view, const Stage& stage, const ScreenRect& rect);

/// A motion's quantity at the cursor, and where it is greatest and least.
void drawMotionNumbers(const MotionPlot& plot, const Stage& stage, const ScreenRect& rect);

} // namespace splineloft::ui
