// The life of the editor: wait, take events, run a frame, draw it.
#pragma once

#include "app/attendant.h"
#include "app/window.h"
#include "ui/input.h"

namespace splineloft::app {

/// Runs the editor in `window`, whose events arrive in `queue`, until the attendant ends it. Starts
/// and stops the interface. Sleeps while nothing happens and nothing is due. Throws WindowError
/// when the fonts or shaders cannot be loaded.
void runEditor(Window& window, ui::InputQueue& queue, ui::Session& session, Attendant& attendant);

} // namespace splineloft::app
