#include "ui/theme.h"

#include <algorithm>
#include <cmath>

namespace splineloft::ui {
namespace {

constexpr Colour hex(unsigned rgb) {
    return {static_cast<std::uint8_t>(rgb >> 16), static_cast<std::uint8_t>(rgb >> 8 & 0xff),
            static_cast<std::uint8_t>(rgb & 0xff), 255};
}

const Theme dark{
    ThemeKind::dark,
    {.canvas = hex(0x0f1216),
     .panel = hex(0x1a1e24),
     .raised = hex(0x2a333e),
     .field = hex(0x12161b),
     .line = hex(0x353c46),
     .text = hex(0xeceff3),
     .quiet = hex(0xa3abb6),
     .accent = hex(0x56b4e9),
     .accentSoft = hex(0x24405a),
     .warning = hex(0xf2a65a)},
    {hex(0x56b4e9), hex(0xe69f00), hex(0x2fc79a), hex(0xd98bb8), hex(0xf0e442), hex(0x9fa5ff),
     hex(0xee7b45)},
    {hex(0x9aa3ae), hex(0xe69f00), hex(0x2fc79a), hex(0xd98bb8), hex(0x56b4e9), hex(0xf0e442)}};

const Theme light{
    ThemeKind::light,
    {.canvas = hex(0xfefdf9),
     .panel = hex(0xf2f1ec),
     .raised = hex(0xdfe5ee),
     .field = hex(0xffffff),
     .line = hex(0xc9c8c0),
     .text = hex(0x16181c),
     .quiet = hex(0x565a61),
     .accent = hex(0x0072b2),
     .accentSoft = hex(0xcfe2f0),
     .warning = hex(0xa85400)},
    {hex(0x0072b2), hex(0xc95600), hex(0x007a5c), hex(0xb0508c), hex(0x8a6d00), hex(0x5548b8),
     hex(0xa03030)},
    {hex(0x6a6f77), hex(0xc95600), hex(0x007a5c), hex(0xb0508c), hex(0x0072b2), hex(0x8a6d00)}};

Colour turn(const std::vector<Colour>& colours, int index) {
    return colours[static_cast<std::size_t>(index) % colours.size()];
}

double luminance(Colour colour) {
    const auto linear = [](std::uint8_t part) {
        const double v = part / 255.0;
        return v <= 0.03928 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(colour.red) + 0.7152 * linear(colour.green) +
           0.0722 * linear(colour.blue);
}

/// Width of a role's stroke, design pixels.
float widthOf(Role role) {
    switch (role) {
    case Role::curve: return 3;
    case Role::otherCurve: return 2;
    case Role::curveHalo: return 9;
    case Role::motion:
    case Role::basis:
    case Role::tangentBasis: return 1.8F;
    case Role::ladder: return 1.8F;
    case Role::plotCursor:
    case Role::snap: return 1.5F;
    case Role::frame: return 1.5F;
    case Role::cursorFrame: return 2.4F;
    case Role::stem: return 2;
    case Role::stemFilled: return 3;
    default: return 1;
    }
}

} // namespace

const Theme& themeOf(ThemeKind kind) {
    return kind == ThemeKind::dark ? dark : light;
}

Colour mixed(Colour a, Colour b, double share) {
    const auto part = [share](std::uint8_t x, std::uint8_t y) {
        return static_cast<std::uint8_t>(std::lround(share * x + (1 - share) * y));
    };
    return {part(a.red, b.red), part(a.green, b.green), part(a.blue, b.blue), 255};
}

double contrast(Colour a, Colour b) {
    const double x = luminance(a);
    const double y = luminance(b);
    return (std::max(x, y) + 0.05) / (std::min(x, y) + 0.05);
}

Colour colourOf(const Theme& theme, const Ink& ink) {
    const auto& s = theme.surfaces;
    switch (ink.role) {
    case Role::gridFine: return mixed(s.text, s.canvas, 0.055);
    case Role::gridCoarse: return mixed(s.text, s.canvas, 0.13);
    case Role::gridAxis: return mixed(s.text, s.canvas, 0.26);
    case Role::gridNumber: return mixed(s.text, s.canvas, 0.5);
    case Role::curve: return ink.index > 0 ? turn(theme.controls, ink.index - 1) : s.text;
    case Role::otherCurve:
    case Role::otherControl:
        return ink.index > 0 ? turn(theme.controls, ink.index - 1) : mixed(s.text, s.canvas, 0.47);
    case Role::curveHalo: return mixed(s.accent, s.canvas, 0.3);
    case Role::polygon: return mixed(s.text, s.canvas, 0.5);
    case Role::handleLine: return mixed(s.text, s.canvas, 0.6);
    case Role::control:
    case Role::handle:
    case Role::basis:
    case Role::tangentBasis: return turn(theme.controls, ink.index);
    case Role::selected: return s.text;
    case Role::hovered: return mixed(s.text, s.canvas, 0.6);
    case Role::ghost: return mixed(s.accent, s.canvas, 0.8);
    case Role::ladder: return turn(theme.levels, ink.index);
    case Role::tip: return s.text;
    case Role::comb: return mixed(s.accent, s.canvas, 0.38);
    case Role::combEdge: return mixed(s.accent, s.canvas, 0.75);
    case Role::bead: return mixed(s.accent, s.canvas, 0.9);
    case Role::joint: return s.accent;
    case Role::frame:
    case Role::cursorFrame: return turn(theme.controls, ink.index);
    case Role::jointNote: return s.text;
    case Role::box: return s.accent;
    case Role::snap: return s.warning;
    case Role::course: return mixed(s.warning, s.canvas, 0.6);
    case Role::gizmo: return mixed(s.accent, s.canvas, 0.75);
    case Role::grip:
    case Role::gripHeld:
    case Role::stemFilled: return s.accent;
    case Role::stem: return mixed(s.text, s.canvas, 0.45);
    case Role::plotAxis: return mixed(s.text, s.panel, 0.22);
    case Role::plotZero: return mixed(s.text, s.panel, 0.4);
    case Role::plotJoint: return mixed(s.text, s.panel, 0.34);
    case Role::motion: return s.accent;
    case Role::plotBand: return mixed(s.accent, s.panel, 0.14);
    case Role::plotCursor: return s.text;
    case Role::plotText: return s.quiet;
    }
    return s.text;
}

StrokeStyle strokeOf(const Theme& theme, const Ink& ink, double scale) {
    const auto pixels = static_cast<float>(scale);
    StrokeStyle style{.width = widthOf(ink.role) * pixels, .colour = colourOf(theme, ink)};
    if (ink.role == Role::polygon || ink.role == Role::box || ink.role == Role::course ||
        ink.role == Role::tangentBasis) {
        style.dash = 6 * pixels;
        style.gap = 5 * pixels;
    } else if (ink.role == Role::plotJoint) {
        style.dash = 1.5F * pixels;
        style.gap = 3.5F * pixels;
    }
    return style;
}

double markRadius(const Ink& ink, double scale) {
    switch (ink.role) {
    case Role::control: return 6.5 * scale;
    case Role::handle: return 5 * scale;
    case Role::otherControl: return 4 * scale;
    case Role::selected: return 11 * scale;
    case Role::hovered: return 10 * scale;
    case Role::ghost: return 5 * scale;
    case Role::motion:
    case Role::basis:
    case Role::tangentBasis:
    case Role::ladder: return 4.5 * scale;
    case Role::tip: return 7 * scale;
    case Role::bead: return 3.5 * scale;
    case Role::joint: return 5 * scale;
    case Role::frame: return 4 * scale;
    case Role::cursorFrame: return 6 * scale;
    case Role::snap: return 9 * scale;
    case Role::grip:
    case Role::gripHeld: return 6 * scale;
    default: return 4 * scale;
    }
}

} // namespace splineloft::ui
