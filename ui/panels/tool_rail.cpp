#include "ui/commands.h"
#include "ui/panels/panels.h"
#include "ui/widgets.h"

#include <imgui.h>

#include <algorithm>
#include <array>

namespace splineloft::ui {
namespace {

/// A button of the rail: a sign that the fonts have, and the command behind it.
struct RailButton {
    const char* sign;
    const char* command;
    bool startsGroup = false;
};

constexpr std::array buttons = {RailButton{"↖", "tool.select"},      RailButton{"✎", "tool.pen"},
                                RailButton{"⌂", "view.fit", true},   RailButton{"▲", "view.ladder"},
                                RailButton{"≋", "view.comb"},        RailButton{"∴", "view.beads"},
                                RailButton{"◎", "view.joints"},      RailButton{"∟", "view.frames"},
                                RailButton{"▷", "motion.play", true}};

// Design pixels.
constexpr double usualSide = 34;
constexpr double railGap = 7;
constexpr double railMargin = 8;
constexpr double linesGap = 9; // around the line above a group

constexpr double roomForUsualSigns = 0.6; // part of the usual side

/// Where the window is low everything comes closer together, so that no button is cut off.
double squeeze(const Stage& stage) {
    const auto groups = std::ranges::count(buttons, true, &RailButton::startsGroup);
    const double wanted = static_cast<double>(buttons.size()) * (usualSide + railGap) +
                          static_cast<double>(groups) * (2 * linesGap + railGap) + 2 * railMargin;
    return std::min(stage.rect.height / stage.scale / wanted, 1.0);
}

void drawLine(const Stage& stage, double gap) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float y = at.y + stage.px(gap);
    ImGui::GetWindowDrawList()->AddLine({at.x, y}, {at.x + stage.px(usualSide), y},
                                        packed(stage.theme.surfaces.line));
    ImGui::Dummy({0, stage.px(2 * gap)});
}

void drawButton(Session& session, const RailButton& button, double height, const Stage& stage) {
    const auto& command = commandNamed(button.command);
    const auto& s = stage.theme.surfaces;
    const bool on = command.checked && command.checked(session);
    ImGui::PushStyleColor(ImGuiCol_Button, packed(on ? s.accentSoft : s.panel));
    ImGui::PushStyleColor(ImGuiCol_Text, packed(on ? s.text : s.quiet));
    ImGui::PushStyleVar(ImGuiStyleVar_FrameBorderSize, 0);
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {0, 0});
    ImGui::BeginDisabled(!command.possible(session));
    if (ImGui::Button(button.sign, {stage.px(usualSide), stage.px(height)})) {
        command.run(session);
    }
    ImGui::EndDisabled();
    ImGui::PopStyleVar(2);
    ImGui::PopStyleColor(2);
    const auto keys = shortcutName(session, command);
    explain(command.name(session) + (keys.empty() ? "" : "  (" + keys + ")"));
}

} // namespace

void drawToolRail(Session& session, const Stage& stage) {
    const double part = squeeze(stage);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {stage.px(6), stage.px(part * railMargin)});
    beginPanel("tools", stage, ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
    ImGui::PopStyleVar();
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, stage.px(part * railGap)});
    ImGui::PushFont(font(part < roomForUsualSigns ? Face::small : Face::regular));
    for (const auto& button : buttons) {
        if (button.startsGroup) {
            drawLine(stage, part * linesGap);
        }
        drawButton(session, button, part * usualSide, stage);
    }
    ImGui::PopFont();
    ImGui::PopStyleVar();
    ImGui::End();
}

} // namespace splineloft::ui
