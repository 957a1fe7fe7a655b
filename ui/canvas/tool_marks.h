// What the hand works with on the canvas: the frame around a selection, the numbers at a point, the
// rubber band, what a drag keeps to and has snapped to.
#pragma once

#include "ui/canvas/gesture.h"
#include "ui/canvas/scene.h"

namespace splineloft::ui {

/// Adds them on top of all that is in the scene.
void drawToolMarks(Scene& scene, const View& view, const Gesture& gesture,
                   const Situation& situation);

} // namespace splineloft::ui
