#include "ui/commands.h"
#include "ui/panels/panels.h"
#include "ui/widgets.h"

#include <imgui.h>

#include <array>

namespace splineloft::ui {
namespace {

/// A button of the rail: a sign that the fonts have, and the command behind it.
struct RailButton {
    const char* sign;
    const char* command;
    bool startsGroup = false;
};

constexpr std::array buttons = {
    RailButton{"↖", "tool.select"},    RailButton{"✎", "tool.pen"},
    RailButton{"⌂", "view.fit", true}, RailButton{"▲", "view.ladder"},
    RailButton{"≋", "view.comb"},      RailButton{"∴", "view.beads"},
    RailButton{"◎", "view.joints"},    RailButton{"▷", "motion.play", true}};

void drawButton(Session& session, const RailButton& button, const Stage& stage) {
    const auto& command = commandNamed(button.command);
    const auto& s = stage.theme.surfaces;
    const bool on = command.checked && command.checked(session);
    const float side = stage.px(34);
    ImGui::PushStyleColor(ImGuiCol_Button, packed(on ? s.accentSoft : s.panel));
    ImGui::PushStyleColor(ImGuiCol_Text, packed(on ? s.text : s.quiet));
    ImGui::PushStyleVar(ImGuiStyleVar_FrameBorderSize, 0);
    if (ImGui::Button(button.sign, {side, side}) && command.possible(session)) {
        command.run(session);
    }
    ImGui::PopStyleVar();
    ImGui::PopStyleColor(2);
    explain(command.name(session) +
            (command.shortcuts.empty() ? "" : "  (" + nameOf(command.shortcuts.front()) + ")"));
}

} // namespace

void drawToolRail(Session& session, const Stage& stage) {
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {stage.px(6), stage.px(8)});
    beginPanel("tools", stage, ImGuiWindowFlags_NoScrollbar);
    ImGui::PopStyleVar();
    for (const auto& button : buttons) {
        if (button.startsGroup) {
            ImGui::Spacing();
            ImGui::Separator();
            ImGui::Spacing();
        }
        drawButton(session, button, stage);
    }
    ImGui::End();
}

} // namespace splineloft::ui
