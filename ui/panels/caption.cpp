#include "ui/canvas/wording.h"
#include "ui/panels/panels.h"
#include "ui/widgets.h"

#include <imgui.h>

namespace splineloft::ui {
namespace {

constexpr float mostForName = 0.35F; // of the width

} // namespace

void drawCaption(const Session& session, const Stage& stage) {
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {stage.px(14), stage.px(4)});
    beginPanel("caption", stage, ImGuiWindowFlags_NoScrollbar);
    ImGui::PopStyleVar();
    const auto& notice = session.notice;
    const auto& s = stage.theme.surfaces;
    const std::string right = notice ? notice->text : "Esc leaves";
    const Study* study = session.active();
    if (study != nullptr) {
        ImGui::PushFont(font(Face::bold));
        const float most = mostForName * static_cast<float>(stage.rect.width);
        ImGui::TextUnformatted(cutToFit(study->curve().name, most).c_str());
        ImGui::PopFont();
        ImGui::SameLine(0, stage.px(14));
        ImGui::TextUnformatted(std::string(study->family().name).c_str());
        ImGui::SameLine(0, stage.px(14));
        ImGui::TextDisabled("u = %s", fixed(session.view.cursor.u, 3).c_str());
        ImGui::SameLine();
    }
    const float taken = ImGui::GetCursorPosX() + stage.px(14);
    const float room = static_cast<float>(stage.rect.width) - taken - stage.px(14);
    const auto words = cutToFit(right, room);
    const float width = ImGui::CalcTextSize(words.c_str()).x;
    ImGui::SetCursorPosX(static_cast<float>(stage.rect.width) - width - stage.px(14));
    const Colour colour = !notice ? s.quiet : notice->isProblem ? s.warning : s.text;
    ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(packed(colour)), "%s", words.c_str());
    ImGui::End();
}

} // namespace splineloft::ui
