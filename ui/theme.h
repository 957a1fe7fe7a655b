// How roles look: colours, widths and sizes, in a dark and a light theme, both made for a
// projector.
#pragma once

#include "ui/canvas/scene.h"
#include "ui/canvas/view.h"

#include <string_view>
#include <vector>

namespace splineloft::ui {

/// Colours of the panels.
struct Surfaces {
    Colour canvas, panel, raised, field, line, text, quiet, accent, accentSoft, warning;
};

struct Theme {
    ThemeKind kind;
    Surfaces surfaces;
    std::vector<Colour> controls; ///< of the control points, in turn; Okabe and Ito's, ordered
    std::vector<Colour> levels;   ///< of the ladder's levels, in turn
};

const Theme& themeOf(ThemeKind kind);

/// The colour of a role. Always opaque: what is faint is mixed with the canvas beforehand.
Colour colourOf(const Theme& theme, const Ink& ink);
/// Stroke of a role, at `scale` pixels per design pixel.
StrokeStyle strokeOf(const Theme& theme, const Ink& ink, double scale);
/// Mark of a role: half its width in pixels.
double markRadius(const Ink& ink, double scale);

/// Contrast of two colours, 1 to 21 (WCAG 2: relative luminance).
double contrast(Colour a, Colour b);

/// `share` of a, the rest of b.
Colour mixed(Colour a, Colour b, double share);

} // namespace splineloft::ui
