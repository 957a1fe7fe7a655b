// Where a panel stands and how it looks: what every panel needs in order to draw.
#pragma once

#include "ui/theme.h"

struct ImFont;

namespace splineloft::ui {

/// One panel's place on the screen.
struct Stage {
    const Theme& theme;
    double scale = 1; ///< pixels per design pixel
    ScreenRect rect;

    /// Design pixels as pixels, for Dear ImGui.
    float px(double designPixels) const { return static_cast<float>(designPixels * scale); }
};

/// The rectangles of the window.
struct Layout {
    ScreenRect menu, tools, canvas, inspector, strip, status;
};

/// Divides a window of so many pixels; `strip` is the height of the plots in design pixels, 0 where
/// they are hidden.
Layout layOut(double width, double height, double scale, double strip);

/// The three faces that `loadFonts` loads.
enum class Face { regular, small, bold };
ImFont* font(Face face);

/// Colours and sizes of Dear ImGui's own widgets.
void applyStyle(const Theme& theme, double scale);

/// As Dear ImGui wants it.
unsigned packed(Colour colour);

} // namespace splineloft::ui
