// The submenu of the files that were opened or saved lately.
#include "ui/file_choice.h"
#include "ui/panels/panels.h"
#include "ui/widgets.h"

#include <imgui.h>

namespace splineloft::ui {

void drawRecentMenu(Session& session) {
    if (!ImGui::BeginMenu("Open recent", !session.recent.empty())) {
        return;
    }
    if (ImGui::IsWindowAppearing()) {
        session.requests.emplace_back(LookForRecent{});
    }
    for (const auto& file : session.recent) {
        if (ImGui::MenuItem(nameWithFolder(file.path).c_str(), nullptr, false, file.isThere)) {
            session.leave(GoToFiles{{file.path}});
        }
    }
    ImGui::Separator();
    if (ImGui::MenuItem("Clear the list")) {
        session.requests.emplace_back(ForgetRecent{});
    }
    ImGui::EndMenu();
}

} // namespace splineloft::ui
