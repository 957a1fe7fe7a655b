#include "ui/commands.h"
#include "ui/panels/panels.h"
#include "ui/widgets.h"

#include <imgui.h>

#include <array>

namespace splineloft::ui {
namespace {

constexpr std::array menus = {"File",  "Edit",   "View",   "Points",
                              "Curve", "Family", "Motion", "Help"};

void drawCommand(Session& session, const Command& command) {
    if (command.startsGroup) {
        ImGui::Separator();
    }
    const auto keys = command.shortcuts.empty() ? std::string() : nameOf(command.shortcuts.front());
    const bool checked = command.checked && command.checked(session);
    const bool possible = command.possible(session);
    if (ImGui::MenuItem(command.name(session).c_str(), keys.c_str(), checked, possible)) {
        command.run(session);
    }
}

} // namespace

void drawMenuBar(Session& session, const Stage& stage) {
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {stage.px(9), stage.px(7.5)});
    const bool shown = ImGui::BeginMainMenuBar();
    ImGui::PopStyleVar();
    if (!shown) {
        return;
    }
    for (const char* menu : menus) {
        if (ImGui::BeginMenu(menu)) {
            for (const auto& command : commands()) {
                if (command.menu == menu) {
                    drawCommand(session, command);
                }
            }
            ImGui::EndMenu();
        }
    }
    const std::string title = session.fileName() + (session.unsaved() ? " ●" : "");
    const float width = ImGui::CalcTextSize(title.c_str()).x;
    const float after = ImGui::GetCursorPosX() + stage.px(20);
    const float wanted = ImGui::GetWindowWidth() - width - stage.px(20);
    if (wanted > after) {
        ImGui::SetCursorPosX(wanted);
        ImGui::TextDisabled("%s", title.c_str());
    }
    ImGui::EndMainMenuBar();
}

} // namespace splineloft::ui
