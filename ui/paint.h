// From roles to colours: a scene becomes a picture that the renderer can draw.
#pragma once

#include "ui/theme.h"

namespace splineloft::ui {

/// Colours a scene. `background` fills its frame.
Picture paint(const Scene& scene, const Theme& theme, Colour background, double scale);

} // namespace splineloft::ui
