// The frames that go along with a curve, as arrows at its beads and at the cursor.
#pragma once

#include "ui/canvas/scene.h"
#include "ui/canvas/viewport.h"
#include "ui/study.h"

namespace splineloft::ui {

/// Adds an arrow for the tangent and one for each normal, as they look in the plane of the canvas:
/// those in space are as short as they are seen. A curve of one coordinate has the frames of its
/// graph.
void drawFrames(Scene& scene, const Study& study, const View& view, const Viewport& viewport,
                double scale);

} // namespace splineloft::ui
