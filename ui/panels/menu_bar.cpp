#include "ui/panels/menus.h"
#include "ui/panels/panels.h"
#include "ui/widgets.h"

#include <imgui.h>

namespace splineloft::ui {

void drawMenuItem(Session& session, const Command& command) {
    // The name of what is undone may hold one of a curve, of any length.
    const auto name = cutToFit(command.name(session), 24 * ImGui::GetFontSize());
    const auto keys = shortcutName(session, command);
    const bool checked = command.checked && command.checked(session);
    const bool possible = command.possible(session);
    if (ImGui::MenuItem(name.c_str(), keys.c_str(), checked, possible)) {
        command.run(session);
    }
}

static void drawSubmenu(Session& session, const Command& first) {
    if (ImGui::BeginMenu(first.submenu.c_str())) {
        for (const auto& command : commands()) {
            if (command.menu == first.menu && command.submenu == first.submenu) {
                drawMenuItem(session, command);
            }
        }
        ImGui::EndMenu();
    }
}

/// The commands of a menu in their order, a submenu where the first of its own stands.
static void drawEntries(Session& session, const std::string& menu) {
    std::string last; // submenu
    for (const auto& command : commands()) {
        if (command.menu != menu || (!command.submenu.empty() && command.submenu == last)) {
            continue;
        }
        if (command.startsGroup) {
            ImGui::Separator();
        }
        last = command.submenu;
        if (!last.empty()) {
            drawSubmenu(session, command);
            continue;
        }
        drawMenuItem(session, command);
        if (command.id == "file.open") {
            drawRecentMenu(session);
        }
    }
}

void drawMenuBar(Session& session, const Stage& stage) {
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {stage.px(9), stage.px(7.5)});
    const bool shown = ImGui::BeginMainMenuBar();
    ImGui::PopStyleVar();
    if (!shown) {
        return;
    }
    for (const char* menu : menuTitles) {
        if (ImGui::BeginMenu(menu)) {
            drawEntries(session, menu);
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
