#include "ui/panels/palette.h"

#include "ui/command_search.h"
#include "ui/imgui_compat.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

namespace splineloft::ui {
namespace {

// Design pixels.
constexpr double usualWidth = 560;
constexpr double commandHeight = 28;
constexpr double top = 40;
constexpr double fieldAndMargins = 90;

constexpr int mostCommands = 12;

/// The title with its matched letters set off, from a place on.
void drawTitle(const FoundCommand& found, ImVec2 at, Colour colour, Colour matched) {
    auto& list = *ImGui::GetWindowDrawList();
    const auto& title = found.title;
    for (std::size_t from = 0; from < title.size();) {
        const bool hit = std::ranges::binary_search(found.letters, from);
        std::size_t to = from + 1;
        // One letter, however many bytes, or all up to the next matched one.
        const auto goesOn = [&] {
            const bool withinLetter = (static_cast<unsigned char>(title[to]) & 0xc0U) == 0x80U;
            return withinLetter || (!hit && !std::ranges::binary_search(found.letters, to));
        };
        while (to < title.size() && goesOn()) {
            ++to;
        }
        ImFont& face = *font(hit ? Face::bold : Face::regular);
        const char* const begin = title.data() + from;
        const char* const end = title.data() + to;
        list.AddText(&face, face.FontSize, at, packed(hit ? matched : colour), begin, end);
        at.x += face.CalcTextSizeA(face.FontSize, 1e6F, 0, begin, end).x;
        from = to;
    }
}

/// One row; returns whether it was clicked.
bool drawRow(const Session& session, const FoundCommand& found, bool chosen, const Stage& window) {
    const auto& s = window.theme.surfaces;
    const bool possible = found.command->possible(session);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x;
    const bool clicked = ImGui::Selectable(("##" + found.command->id).c_str(), chosen, 0,
                                           {0, window.px(commandHeight)});
    const float y = corner.y + (window.px(commandHeight) - ImGui::GetTextLineHeight()) / 2;
    // What is impossible now is as quiet as it can be and still be read on any ground.
    const Colour colour = possible ? s.text : mixed(s.text, s.panel, 0.6);
    drawTitle(found, {corner.x + window.px(8), y}, colour, possible ? s.accent : colour);
    const auto keys = shortcutName(session, *found.command);
    const float x = corner.x + width - ImGui::CalcTextSize(keys.c_str()).x - window.px(8);
    ImGui::GetWindowDrawList()->AddText({x, y}, packed(colour), keys.c_str());
    return clicked;
}

/// Up and down from row to row, around at the ends; returns whether it moved.
bool moveChoice(Palette& palette, std::size_t count) {
    if (count == 0) {
        return false;
    }
    palette.chosen = std::min(palette.chosen, count - 1);
    if (ImGui::IsKeyPressed(downKey())) {
        palette.chosen = (palette.chosen + 1) % count;
        return true;
    }
    if (ImGui::IsKeyPressed(upKey())) {
        palette.chosen = (palette.chosen + count - 1) % count;
        return true;
    }
    return false;
}

void run(Session& session, const Command& command) {
    if (!command.possible(session)) {
        return;
    }
    std::erase(session.recentCommands, command.id);
    session.recentCommands.insert(session.recentCommands.begin(), command.id);
    session.dialog.reset();
    command.run(session);
}

} // namespace

double paletteTop(const Stage& window) {
    return top * window.scale;
}

double paletteWidth(const Stage& window) {
    return std::min(usualWidth * window.scale, window.rect.width - 40 * window.scale);
}

void drawPalette(Session& session, const Stage& window) {
    auto& palette = std::get<Palette>(*session.dialog);
    if (!ImGui::IsAnyItemActive()) {
        ImGui::SetKeyboardFocusHere();
    }
    ImGui::SetNextItemWidth(-1);
    const bool entered =
        ImGui::InputTextWithHint("##typed", "Type a few letters of a command", palette.typed.data(),
                                 palette.typed.size(), ImGuiInputTextFlags_EnterReturnsTrue);
    if (ImGui::IsItemEdited()) {
        palette.chosen = 0;
    }
    const auto found = findCommands(session, palette.typed.data());
    const bool moved = moveChoice(palette, found.size());
    const double room = window.rect.height / window.scale - top - fieldAndMargins;
    const auto rows =
        std::min({static_cast<double>(found.size()), static_cast<double>(mostCommands),
                  std::max(std::floor(room / commandHeight), 1.0)});
    const Command* taken = nullptr;
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
    if (found.empty()) {
        ImGui::TextDisabled("No command is called that.");
    } else if (ImGui::BeginChild("found",
                                 {0, static_cast<float>(rows) * window.px(commandHeight)})) {
        for (std::size_t i = 0; i < found.size(); ++i) {
            if (drawRow(session, found[i], i == palette.chosen, window)) {
                taken = found[i].command;
            }
            if (i == palette.chosen && moved) {
                ImGui::SetScrollHereY();
            }
        }
    }
    if (!found.empty()) {
        ImGui::EndChild();
    }
    ImGui::PopStyleVar();
    if (entered && !found.empty()) {
        taken = found[palette.chosen].command;
    }
    if (taken != nullptr) {
        run(session, *taken);
    }
}

} // namespace splineloft::ui
