// Every key and what the mouse does, on one page.
#pragma once

#include "ui/session.h"
#include "ui/stage.h"

namespace splineloft::ui {

/// Draws the inside of the list; returns whether it was closed.
bool drawKeyList(const Session& session, const Stage& window);

} // namespace splineloft::ui
