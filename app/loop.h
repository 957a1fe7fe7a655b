// The life of the editor: wait, take events, run a frame, draw it.
#pragma once

#include "app/window.h"
#include "ui/frame.h"
#include "ui/input.h"

#include <functional>

namespace splineloft::app {

/// Carries out what the session asks of the program after a frame; false ends the program.
using AfterFrame = std::function<bool(ui::Session&)>;

/// Runs the editor in `window`, whose events arrive in `queue`, until `afterFrame` returns false.
/// Starts and stops the interface. Sleeps while nothing happens. Throws WindowError when the fonts
/// or shaders cannot be loaded.
void runEditor(Window& window, ui::InputQueue& queue, ui::Session& session,
               const AfterFrame& afterFrame);

} // namespace splineloft::app
