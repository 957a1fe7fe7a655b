// A document drawn as small as a stamp.
#pragma once

#include "core/document/document.h"
#include "ui/drawing.h"

#include <vector>

namespace splineloft::ui {

inline constexpr double thumbnailWidth = 120, thumbnailHeight = 76; // design pixels

/// Its curves as lines within a box of that size, the top left corner at (0, 0), y down.
using Thumbnail = std::vector<std::vector<ScreenPoint>>;

Thumbnail thumbnailOf(const Document& document);

} // namespace splineloft::ui
