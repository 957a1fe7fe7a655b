// The basis functions as a picture: over the whole parameter range, and the segments of one piece.
#pragma once

#include "ui/canvas/scene.h"
#include "ui/study.h"

#include <optional>

namespace splineloft::ui {

/// A rectangle of a plot and the values that lie along its sides.
struct PlotFrame {
    ScreenRect frame;
    double left = 0, right = 1; ///< values across
    double low = 0, high = 1;   ///< values up

    ScreenPoint at(double x, double y) const;
    /// The value across that is under a pixel, kept inside.
    double across(double pixel) const;
};

/// What stands out: the control under the pointer or selected.
struct Emphasis {
    std::optional<std::size_t> control;
};

/// Where the basis functions of a curve are drawn inside `frame`: all values fit.
PlotFrame wholeRangeFrame(const Study& study, const ScreenRect& frame);
/// The same for the segments of one piece, u from 0 to 1.
PlotFrame segmentFrame(const Study& study, const ScreenRect& frame);

/// Every basis function over the whole parameter range, the piece at the cursor, the cursor at u.
void drawBasis(Scene& scene, const PlotFrame& plot, const Study& study, Spot cursor,
               const Emphasis& emphasis, double scale);

/// The basis segments of the piece at the cursor: what each control point contributes there.
void drawSegments(Scene& scene, const PlotFrame& plot, const Study& study, Spot cursor,
                  const Emphasis& emphasis, double scale);

} // namespace splineloft::ui
