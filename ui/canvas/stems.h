// The numbers of the selected point at the point itself: stems whose knobs the hand slides.
#pragma once

#include "ui/canvas/point_values.h"
#include "ui/canvas/viewport.h"
#include "ui/study.h"

#include <optional>
#include <vector>

namespace splineloft::ui {

/// One number of one point: a straight track that leads away from the point, and the knob on it.
struct Stem {
    PointId point;
    PointValue value;
    double number = 0;
    ScreenPoint from, to; ///< ends of the track, pixels
    ScreenPoint knob;

    /// What the number would be with the knob as near to a place as the track lets it.
    double numberAt(ScreenPoint at) const;
    /// "w = 1.5"
    std::string words() const;
};

/// The stems of the one control point of the active curve that is selected; none where several are.
std::vector<Stem> stemsOf(const Document& document, const View& view, const Viewport& viewport,
                          double scale);

/// The stem whose knob is within reach of a place on the screen.
std::optional<Stem> stemAt(const std::vector<Stem>& stems, ScreenPoint at, double scale);

} // namespace splineloft::ui
