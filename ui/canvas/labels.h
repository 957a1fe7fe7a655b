// Where labels go so that none lies on another, on a mark, or outside the picture.
#pragma once

#include "ui/canvas/scene.h"

#include <functional>
#include <vector>

namespace splineloft::ui {

/// Width and height of a text in pixels.
struct TextSize {
    double width = 0, height = 0;
};

using MeasureText = std::function<TextSize(const SceneLabel&)>;

/// A label and the rectangle that was found for it.
struct PlacedLabel {
    const SceneLabel* label = nullptr;
    ScreenRect rect;
};

/// Tries places around each label's point and prefers those with no line under them; a label that
/// is not optional and finds no room takes its first place all the same. Fixed labels stay where
/// they are, unless something already lies there.
std::vector<PlacedLabel> placeLabels(const Scene& scene, const MeasureText& measure,
                                     double markRadius);

} // namespace splineloft::ui
