// A field in which any command is found by a few letters of its name.
#pragma once

#include "ui/session.h"
#include "ui/stage.h"

namespace splineloft::ui {

/// Draws the inside of the palette and runs the command that is taken, which closes it.
void drawPalette(Session& session, const Stage& window);

/// Where its upper edge stands, pixels from the top of the window, and how wide it is.
double paletteTop(const Stage& window);
double paletteWidth(const Stage& window);

} // namespace splineloft::ui
