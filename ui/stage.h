// Where a panel stands and how it looks: what every panel needs in order to draw.
#pragma once

#include "ui/theme.h"

struct ImFont;

namespace splineloft::ui {

/// The window as the interface sees it.
struct Screen {
    int width = 1280, height = 800; ///< framebuffer pixels
    double scale = 1;               ///< pixels per design pixel: 1 at 96 dpi, 2 at 192 dpi
};

/// One panel's place on the screen.
struct Stage {
    const Theme& theme;
    double scale = 1; ///< pixels per design pixel
    ScreenRect rect;

    /// Design pixels as pixels, for Dear ImGui.
    float px(double designPixels) const { return static_cast<float>(designPixels * scale); }
};

/// The rectangles of the window; those of panels that are away have no area.
struct Layout {
    ScreenRect menu, tools, canvas, inspector, strip, status;
};

/// Sizes that a panel may be dragged to, design pixels.
struct SizeRange {
    double least = 0, most = 0;
    double limited(double size) const;
};
SizeRange inspectorRange(const Screen& screen);
SizeRange stripRange(const Screen& screen);

/// The screen at the scale at which the interface draws on it: that of the monitor times the
/// person's own, larger before an audience, smaller where the panels would have no room.
Screen scaled(const Screen& screen, const View& view);

/// Divides a screen, which has the scale that `scaled` gives it.
Layout layOut(const Screen& screen, const View& view);

/// The three faces that `loadFonts` loads.
enum class Face { regular, small, bold };
ImFont* font(Face face);

/// Colours and sizes of Dear ImGui's own widgets.
void applyStyle(const Theme& theme, double scale);

/// As Dear ImGui wants it.
unsigned packed(Colour colour);

} // namespace splineloft::ui
