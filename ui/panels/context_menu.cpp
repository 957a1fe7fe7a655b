#include "ui/commands.h"
#include "ui/panels/menus.h"
#include "ui/panels/panels.h"

#include <imgui.h>

#include <algorithm>

namespace splineloft::ui {
namespace {

// A menu that gives more commands than these opens beside the others.
constexpr std::size_t mostBesideOthers = 8;

bool isOffered(const Command& command, Context context) {
    return std::ranges::find(command.contexts, context) != command.contexts.end();
}

/// The commands that one menu gives to a context.
std::vector<const Command*> offeredBy(const std::string& menu, Context context) {
    std::vector<const Command*> offered;
    for (const auto& command : commands()) {
        if (command.menu == menu && isOffered(command, context)) {
            offered.push_back(&command);
        }
    }
    return offered;
}

void drawCommands(Session& session, Context context) {
    bool first = true;
    for (const char* menu : menuTitles) {
        const auto offered = offeredBy(menu, context);
        if (offered.empty()) {
            continue;
        }
        if (!first) {
            ImGui::Separator();
        }
        first = false;
        const bool beside = offered.size() > mostBesideOthers;
        if (beside && !ImGui::BeginMenu(menu)) {
            continue;
        }
        for (const auto* command : offered) {
            drawMenuItem(session, *command);
        }
        if (beside) {
            ImGui::EndMenu();
        }
    }
}

} // namespace

void drawContextMenu(Session& session, const Stage&) {
    auto& menu = session.contextMenu;
    if (!menu) {
        return;
    }
    if (!menu->shown) {
        ImGui::OpenPopup("context");
        ImGui::SetNextWindowPos({static_cast<float>(menu->at.x), static_cast<float>(menu->at.y)});
        menu->shown = true;
    }
    if (ImGui::BeginPopup("context")) {
        drawCommands(session, menu->context);
        ImGui::EndPopup();
    } else {
        menu.reset();
    }
}

} // namespace splineloft::ui
