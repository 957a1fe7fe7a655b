// Speed, acceleration or curvature of the curve as it is played, over the time of playing.
#pragma once

#include "ui/canvas/plot.h"
#include "ui/canvas/view.h"

#include <string>

namespace splineloft::ui {

/// What a plot of a motion shows, of whom, and where.
struct MotionPlot {
    const Study& study;
    Motion motion;
    const MotionGraph& graph;
    Quantity quantity;
    PlotFrame frame; ///< seconds across, the quantity up
    Spot cursor;
};

/// The plot that the view asks for, inside of `frame`; its curve must have pieces. Nothing where
/// the view asks for the basis functions.
std::optional<MotionPlot> motionPlot(const Study& study, const View& view, const ScreenRect& frame);

/// What the line above the plot tells beside the quantity: its unit, or, where there is no room for
/// numbers beside the plot, the value at the cursor.
enum class Caption { unit, value };

/// Graph, axes, joints and cursor. What leaves the range of the plot is cut off at its edge, where
/// a triangle points to it.
void drawMotion(Scene& scene, const MotionPlot& plot, Caption caption, double scale);

// --- in words

std::string nameOf(Quantity quantity);
std::string unitOf(Quantity quantity);
/// The value at the cursor with its unit: "1.234 units/s".
std::string valueAtCursor(const MotionPlot& plot);
/// A value of the quantity; what is rounding of zero reads as zero.
std::string valueInWords(const MotionPlot& plot, double value);

} // namespace splineloft::ui
