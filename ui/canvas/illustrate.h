// From the document and the way it is looked at to the scene on the canvas.
#pragma once

#include "ui/canvas/gesture.h"
#include "ui/canvas/scene.h"

namespace splineloft::ui {

/// Everything to be seen on the canvas.
Scene illustrate(const View& view, const Gesture& gesture, const Situation& situation);

/// The joint of the active curve under the pointer, as an index into its traits' joints.
std::optional<std::size_t> jointNear(const Study& study, const View& view, const Viewport& viewport,
                                     ScreenPoint at, double reach);

} // namespace splineloft::ui
