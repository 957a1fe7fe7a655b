// The life of the editor: wait, take events, run a frame, draw it.
#pragma once

#include "app/attendant.h"
#include "ui/session.h"

namespace splineloft::app {

/// Opens a window on the session and runs it until the attendant ends it. Starts and stops the
/// interface. Sleeps while nothing happens and nothing is due. Throws WindowError when there is no
/// display to open it on, or fonts or shaders cannot be loaded.
void runEditor(ui::Session& session, Attendant& attendant);

} // namespace splineloft::app
