#include "letters.h"

#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

namespace splineloft::ui {
namespace {

#if IMGUI_VERSION_NUM < 19200

/// Corners of a letter's picture in the texture of the fonts.
using Corners = std::array<float, 4>;

std::map<Corners, char32_t> lettersOfTheFonts() {
    std::map<Corners, char32_t> letters;
    for (const ImFont* font : ImGui::GetIO().Fonts->Fonts) {
        for (const auto& glyph : font->Glyphs) {
            letters[{glyph.U0, glyph.V0, glyph.U1, glyph.V1}] = glyph.Codepoint;
        }
    }
    return letters;
}

/// Letters are pairs of triangles that show a piece of the texture; all else shows a single spot of
/// it, or a row.
bool isQuad(const ImDrawIdx* i) {
    return i[1] == i[0] + 1 && i[2] == i[0] + 2 && i[3] == i[0] && i[4] == i[2] && i[5] == i[0] + 3;
}

void collect(std::vector<DrawnLetter>& found, const ImDrawList& list, const ImDrawCmd& command,
             const std::map<Corners, char32_t>& known) {
    const ImVec4& c = command.ClipRect;
    const ScreenRect clip{c.x, c.y, c.z - c.x, c.w - c.y};
    const auto* index = list.IdxBuffer.Data + command.IdxOffset;
    for (unsigned i = 0; i + 6 <= command.ElemCount;) {
        if (!isQuad(index + i)) {
            i += 3;
            continue;
        }
        const ImDrawVert& a = list.VtxBuffer[static_cast<int>(command.VtxOffset + index[i])];
        const ImDrawVert& b = list.VtxBuffer[static_cast<int>(command.VtxOffset + index[i + 2])];
        if (a.uv.x != b.uv.x && a.uv.y != b.uv.y) {
            const auto letter = known.find({a.uv.x, a.uv.y, b.uv.x, b.uv.y});
            found.push_back({list._OwnerName != nullptr ? list._OwnerName : "",
                             {a.pos.x, a.pos.y, b.pos.x - a.pos.x, b.pos.y - a.pos.y},
                             clip,
                             letter == known.end() ? U'\0' : letter->second});
        }
        i += 6;
    }
}

#endif

/// How far a letter reaches over the edges of what could be drawn on, pixels.
struct Overhang {
    double across = 0, along = 0;
};

Overhang overhang(const DrawnLetter& letter) {
    const auto& [r, c] = std::pair(letter.rect, letter.clip);
    return {std::max(c.left - r.left, r.right() - c.right()),
            std::max(c.top - r.top, r.bottom() - c.bottom())};
}

bool scrolls(const std::string& window) {
    const ImGuiWindow* found = ImGui::FindWindowByName(window.c_str());
    return found != nullptr && found->ScrollMax.y > 0;
}

/// The part of the smaller one of two letters that the other one lies on.
double shared(const ScreenRect& a, const ScreenRect& b) {
    const double across = std::min(a.right(), b.right()) - std::max(a.left, b.left);
    const double along = std::min(a.bottom(), b.bottom()) - std::max(a.top, b.top);
    const double smaller = std::min(a.width * a.height, b.width * b.height);
    return across > 0 && along > 0 && smaller > 0 ? across * along / smaller : 0;
}

/// The line of text around a letter, as far as ASCII tells it.
std::string lineAround(const std::vector<DrawnLetter>& letters, const DrawnLetter& here) {
    std::map<double, char> line;
    for (const auto& other : letters) {
        const double drop = other.rect.bottom() - here.rect.bottom();
        if (other.window == here.window && std::abs(drop) < 4) {
            line[other.rect.left] = other.sign < 128 ? static_cast<char>(other.sign) : '?';
        }
    }
    std::string words;
    for (const auto& [x, sign] : line) {
        words += sign == '\0' ? '|' : sign;
    }
    return here.window + ": “" + words + "” at " + std::to_string(std::lround(here.rect.left)) +
           ", " + std::to_string(std::lround(here.rect.top));
}

} // namespace

std::vector<DrawnLetter> drawnLetters() {
    std::vector<DrawnLetter> found;
#if IMGUI_VERSION_NUM < 19200
    const auto known = lettersOfTheFonts();
    const ImDrawData* data = ImGui::GetDrawData();
    for (int i = 0; data != nullptr && i < data->CmdListsCount; ++i) {
        for (const auto& command : data->CmdLists[i]->CmdBuffer) {
            collect(found, *data->CmdLists[i], command, known);
        }
    }
#endif
    return found;
}

std::vector<std::string> illegible(const std::vector<DrawnLetter>& letters) {
    constexpr double slack = 1;        // pixels: an edge between two of them
    constexpr double mostShared = 0.3; // of a letter
    std::set<std::string> faults;
    for (std::size_t i = 0; i < letters.size(); ++i) {
        const auto& letter = letters[i];
        if (letter.window == "##Background") {
            continue;
        }
        const auto over = overhang(letter);
        const bool mayScroll = scrolls(letter.window);
        if (over.across > slack || (over.along > slack && !mayScroll) ||
            (letter.sign == U'\0' && !mayScroll)) {
            faults.insert("cut off in " + lineAround(letters, letter));
        }
        for (std::size_t k = i + 1; k < letters.size(); ++k) {
            if (letters[k].window == letter.window &&
                shared(letter.rect, letters[k].rect) > mostShared) {
                faults.insert("on one another in " + lineAround(letters, letter));
            }
        }
    }
    return {faults.begin(), faults.end()};
}

} // namespace splineloft::ui
