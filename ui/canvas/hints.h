// What things are called and what the mouse would do now, in words.
#pragma once

#include "ui/canvas/gesture.h"

#include <string>
#include <vector>

namespace splineloft::ui {

/// "P₃", "handle P₄", "tangent at P₂" or "3 points", for menus and the status line.
std::string nameOf(const Document& document, const std::vector<PointId>& ids);

/// What the mouse would do now, in one line.
std::string hintFor(const Gesture& gesture, const View& view, const Document& document);

} // namespace splineloft::ui
