// Where the canvas is in a window of the usual size, for tests without a window.
#pragma once

#include "ui/canvas/viewport.h"

namespace splineloft::ui {

inline constexpr ScreenRect usualFrame{46, 32, 922, 532};

} // namespace splineloft::ui
