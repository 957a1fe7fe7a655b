// Text on canvas and plots: names with lowered indices, labels that keep clear of one another.
#pragma once

#include "ui/canvas/scene.h"
#include "ui/stage.h"

#include <string_view>

struct ImDrawList;

namespace splineloft::ui {

/// Width in pixels of a text in which "_" lowers what follows up to a space.
double mathWidth(std::string_view text, Face face);

/// Draws such a text with its top left corner at a place.
void drawMath(ImDrawList& list, ScreenPoint topLeft, Colour colour, std::string_view text,
              Face face);

/// Draws a scene's labels where they find room, on top of everything drawn so far.
void drawLabels(ImDrawList& list, const Scene& scene, const Theme& theme, Colour background,
                double scale);

} // namespace splineloft::ui
