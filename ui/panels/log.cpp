// The panel that shows what the program has said, the latest at the bottom.
#include "ui/panels/panels.h"
#include "ui/widgets.h"

#include <imgui.h>

namespace splineloft::ui {

void drawLog(Session& session, const Stage& stage) {
    beginPanel("log", stage);
    const auto& s = stage.theme.surfaces;
    ImGui::AlignTextToFramePadding();
    ImGui::TextDisabled("Messages");
    ImGui::SameLine();
    if (quietButton("Copy", false, stage)) {
        ImGui::SetClipboardText(session.log.text().c_str());
    }
    ImGui::SameLine();
    session.view.log = !quietButton("Close", false, stage);
    if (ImGui::BeginChild("messages")) {
        const bool atEnd = ImGui::GetScrollY() >= ImGui::GetScrollMaxY();
        for (const auto& message : session.log.messages()) {
            ImGui::PushStyleColor(ImGuiCol_Text, packed(message.isProblem ? s.warning : s.text));
            ImGui::PushTextWrapPos(0);
            ImGui::TextUnformatted(lineFor(message).c_str());
            ImGui::PopTextWrapPos();
            ImGui::PopStyleColor();
        }
        if (atEnd) {
            ImGui::SetScrollHereY(1);
        }
    }
    ImGui::EndChild();
    ImGui::End();
}

} // namespace splineloft::ui
