// What must be seen can be seen: contrast, colours for every eye, and a glyph for every character.
#include "driver.h"
#include "hand.h"

#include "core/spline/catalog.h"
#include "ui/canvas/hints.h"
#include "ui/canvas/wording.h"
#include "ui/commands.h"
#include "ui/stage.h"

#include <gtest/gtest.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

namespace splineloft::ui {
namespace {

constexpr std::array kinds = {ThemeKind::dark, ThemeKind::light};

const char* nameOf(ThemeKind kind) {
    return kind == ThemeKind::dark ? "dark" : "light";
}

TEST(ThemeContrast, whatIsDrawnOnTheCanvasStandsOut) {
    const std::map<std::string, Role> seen = {{"curve", Role::curve},
                                              {"other curve", Role::otherCurve},
                                              {"polygon", Role::polygon},
                                              {"handle line", Role::handleLine},
                                              {"selected", Role::selected},
                                              {"hovered", Role::hovered},
                                              {"ghost", Role::ghost},
                                              {"tip", Role::tip},
                                              {"comb edge", Role::combEdge},
                                              {"bead", Role::bead},
                                              {"joint", Role::joint},
                                              {"box", Role::box},
                                              {"snap", Role::snap},
                                              {"grid number", Role::gridNumber},
                                              {"other control", Role::otherControl},
                                              {"arrow of a frame", Role::frame},
                                              {"arrow at the cursor", Role::cursorFrame}};
    for (const auto kind : kinds) {
        const Theme& theme = themeOf(kind);
        for (const auto& [name, role] : seen) {
            EXPECT_GE(contrast(colourOf(theme, {role}), theme.surfaces.canvas), 3)
                << nameOf(kind) << ": " << name;
        }
    }
}

TEST(ThemeContrast, controlsAndLevelsStandOutOnCanvasAndPanel) {
    for (const auto kind : kinds) {
        const Theme& theme = themeOf(kind);
        for (std::size_t i = 0; i < theme.controls.size(); ++i) {
            EXPECT_GE(contrast(theme.controls[i], theme.surfaces.canvas), 3) << nameOf(kind) << i;
            EXPECT_GE(contrast(theme.controls[i], theme.surfaces.panel), 3)
                << nameOf(kind) << i << ": its basis function";
        }
        for (std::size_t i = 0; i < theme.levels.size(); ++i) {
            EXPECT_GE(contrast(theme.levels[i], theme.surfaces.canvas), 3) << nameOf(kind) << i;
        }
        EXPECT_GE(contrast(colourOf(theme, {Role::plotCursor}), theme.surfaces.panel), 3);
        EXPECT_GE(contrast(colourOf(theme, {Role::motion}), theme.surfaces.panel), 3);
    }
}

TEST(ThemeContrast, textCanBeRead) {
    for (const auto kind : kinds) {
        const auto& s = themeOf(kind).surfaces;
        for (const auto& [name, ground] :
             std::map<std::string, Colour>{{"panel", s.panel},
                                           {"raised", s.raised},
                                           {"field", s.field},
                                           {"accentSoft", s.accentSoft},
                                           {"canvas", s.canvas}}) {
            EXPECT_GE(contrast(s.text, ground), 7) << nameOf(kind) << " on " << name;
            if (name != "accentSoft" && name != "raised") {
                EXPECT_GE(contrast(s.quiet, ground), 4.5) << nameOf(kind) << " on " << name;
            }
        }
        EXPECT_GE(contrast(s.warning, s.panel), 4.5) << nameOf(kind);
        EXPECT_GE(contrast(s.warning, s.field), 4.5) << nameOf(kind);
        EXPECT_GE(contrast(colourOf(themeOf(kind), {Role::plotText}), s.panel), 4.5);
    }
}

using Vector = std::array<double, 3>;
using Matrix = std::array<Vector, 3>;

Vector times(const Matrix& m, const Vector& v) {
    Vector result{};
    for (std::size_t i = 0; i < 3; ++i) {
        result[i] = m[i][0] * v[0] + m[i][1] * v[1] + m[i][2] * v[2];
    }
    return result;
}

// Machado, Oliveira and Fernandes 2009, severity 1, on linear RGB.
constexpr Matrix normal = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
constexpr Matrix protanopia = {{{0.152286, 1.052583, -0.204868},
                                {0.114503, 0.786281, 0.099216},
                                {-0.003882, -0.048116, 1.051998}}};
constexpr Matrix deuteranopia = {{{0.367322, 0.860646, -0.227968},
                                  {0.280085, 0.672501, 0.047413},
                                  {-0.011820, 0.042940, 0.968881}}};

/// CIE L*a*b* (1976) of a colour as such an eye sees it.
Vector labOf(Colour colour, const Matrix& eye) {
    const auto linear = [](std::uint8_t part) {
        const double v = part / 255.0;
        return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
    };
    Vector rgb = times(eye, {linear(colour.red), linear(colour.green), linear(colour.blue)});
    for (auto& part : rgb) {
        part = std::clamp(part, 0.0, 1.0);
    }
    constexpr Matrix toXyz = {{{0.4124564, 0.3575761, 0.1804375},
                               {0.2126729, 0.7151522, 0.0721750},
                               {0.0193339, 0.1191920, 0.9503041}}};
    const Vector xyz = times(toXyz, rgb);
    const auto f = [](double t) {
        return t > 216.0 / 24389 ? std::cbrt(t) : (24389.0 / 27 * t + 16) / 116;
    };
    const double x = f(xyz[0] / 0.95047), y = f(xyz[1]), z = f(xyz[2] / 1.08883);
    return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

double difference(Colour a, Colour b, const Matrix& eye) {
    const Vector p = labOf(a, eye), q = labOf(b, eye);
    return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

// A difference of 2.3 is just noticed side by side; in thin lines apart it takes some ten times
// that. Neighbours are also told apart by their names, so a little less will do for every eye.
TEST(ThemeColours, neighboursDifferForEveryEye) {
    for (const auto kind : kinds) {
        for (const auto* turn : {&themeOf(kind).controls, &themeOf(kind).levels}) {
            for (std::size_t i = 0; i < turn->size(); ++i) {
                const Colour a = (*turn)[i];
                const Colour b = (*turn)[(i + 1) % turn->size()];
                EXPECT_GE(difference(a, b, normal), 30) << nameOf(kind) << i;
                EXPECT_GE(difference(a, b, protanopia), 15) << nameOf(kind) << i << " protanopia";
                EXPECT_GE(difference(a, b, deuteranopia), 15)
                    << nameOf(kind) << i << " deuteranopia";
            }
        }
    }
}

TEST(ThemeColours, noTwoControlsAreAlike) {
    for (const auto kind : kinds) {
        const auto& colours = themeOf(kind).controls;
        for (std::size_t i = 0; i < colours.size(); ++i) {
            for (std::size_t k = i + 1; k < colours.size(); ++k) {
                EXPECT_GE(difference(colours[i], colours[k], normal), 20)
                    << nameOf(kind) << i << " " << k;
            }
        }
    }
}

// --- characters

/// The characters of a text beyond ASCII.
void collect(std::set<char32_t>& found, std::string_view text) {
    for (std::size_t i = 0; i < text.size();) {
        const auto lead = static_cast<unsigned char>(text[i]);
        const int length = lead < 0x80 ? 1 : lead < 0xe0 ? 2 : lead < 0xf0 ? 3 : 4;
        char32_t sign = length == 1 ? lead : lead & (0x7fU >> length);
        for (int k = 1; k < length && i + static_cast<std::size_t>(k) < text.size(); ++k) {
            sign = sign << 6 |
                   (static_cast<unsigned char>(text[i + static_cast<std::size_t>(k)]) & 0x3fU);
        }
        i += static_cast<std::size_t>(length);
        if (sign > 0x7f) {
            found.insert(sign);
        }
    }
}

/// Everything that is said in the sources, which includes what is put together while it runs.
std::set<char32_t> charactersInSources() {
    std::set<char32_t> found;
    const auto root = std::filesystem::path(SPLINELOFT_TESTS_DIR).parent_path();
    for (const char* folder : {"ui", "core"}) {
        for (const auto& entry : std::filesystem::recursive_directory_iterator(root / folder)) {
            std::ifstream file(entry.path());
            for (std::string line; std::getline(file, line);) {
                collect(found, line.substr(0, line.find("//")));
            }
        }
    }
    return found;
}

std::set<char32_t> charactersShown() {
    std::set<char32_t> found = charactersInSources();
    for (const auto& family : catalog()) {
        for (const auto text : {family.name, family.summary, family.source}) {
            collect(found, text);
        }
        for (const auto& p : family.parameters) {
            for (const auto text : {p.label, p.symbol, p.meaning}) {
                collect(found, text);
            }
        }
        const Study study(std::make_shared<Curve>(curveOf(family.id)));
        for (const auto& joint : study.traits().joints) {
            collect(found, describe(joint));
        }
    }
    const Session session(documentOf({curveOf("cardinal")}));
    for (const auto& command : commands()) {
        collect(found, command.name(session));
        for (const auto& shortcut : command.shortcuts) {
            collect(found, ui::nameOf(shortcut));
        }
    }
    collect(found, plainPointName(1234567890));
    collect(found, fixed(-1.5, 2));
    return found;
}

bool hasGlyph(ImFont& face, char32_t sign) {
#if IMGUI_VERSION_NUM >= 19200
    return face.IsGlyphInFont(static_cast<ImWchar>(sign));
#else
    return face.FindGlyphNoFallback(static_cast<ImWchar>(sign)) != nullptr;
#endif
}

TEST(Glyphs, everyCharacterThatIsShownHasOneInEveryFace) {
    if (testFonts().regular.empty()) {
        GTEST_SKIP() << "DejaVu Sans is not installed where it is looked for";
    }
    const Driver driver;
    const auto shown = charactersShown();
    EXPECT_GT(shown.size(), 20U) << "Greek, indices, arrows and signs";
    for (const auto sign : shown) {
        for (const auto face : {Face::regular, Face::small, Face::bold}) {
            EXPECT_TRUE(hasGlyph(*font(face), sign))
                << "U+" << std::hex << static_cast<unsigned>(sign) << " in face "
                << static_cast<int>(face);
        }
    }
}

} // namespace
} // namespace splineloft::ui
