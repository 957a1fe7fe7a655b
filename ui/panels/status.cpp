#include "ui/canvas/hints.h"
#include "ui/canvas/wording.h"
#include "ui/panels/panels.h"
#include "ui/widgets.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

namespace splineloft::ui {
namespace {

// A unit is this many design pixels at 100 %.
constexpr double fullSize = 80;

/// Pointer, length and zoom.
std::string figures(const Session& session, double scale) {
    std::string text;
    const auto& camera = session.view.camera;
    if (session.pointerOnCanvas) {
        const PlanePoint at = Viewport{camera, session.canvas}.toPlane(session.pointer);
        const double pixel = 1 / camera.pixelsPerUnit;
        text += "x " + decimal(at.x, pixel) + "  y " + decimal(at.y, pixel) + "  ·  ";
    }
    if (const Study* study = session.active(); study != nullptr && study->measuredWhole()) {
        text += "length " + significant(study->lengths().total(), 6) + "  ·  ";
    }
    return text + significant(std::round(100 * camera.pixelsPerUnit / (fullSize * scale)), 6) +
           " %";
}

/// A notice that is too long for its line, above it. Hands reach through it.
void drawWhole(const Notice& notice, const Stage& stage) {
    const auto& s = stage.theme.surfaces;
    ImGui::SetNextWindowPos({static_cast<float>(stage.rect.left) + stage.px(14),
                             static_cast<float>(stage.rect.top) - stage.px(6)},
                            ImGuiCond_Always, {0, 1});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, stage.px(1));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, stage.px(6));
    ImGui::PushStyleColor(ImGuiCol_WindowBg, packed(s.field)); // warnings are read on it
    ImGui::Begin("notice", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoInputs |
                     ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoFocusOnAppearing);
    ImGui::PushStyleColor(ImGuiCol_Text, packed(notice.isProblem ? s.warning : s.text));
    const double width = std::min(0.8 * stage.rect.width, 620 * stage.scale);
    ImGui::TextUnformatted(brokenAtSpaces(notice.text, static_cast<float>(width)).c_str());
    ImGui::PopStyleColor();
    ImGui::End();
    ImGui::PopStyleColor();
    ImGui::PopStyleVar(2);
}

} // namespace

void drawStatus(const Session& session, const Stage& stage) {
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {stage.px(14), stage.px(4)});
    beginPanel("status", stage, ImGuiWindowFlags_NoScrollbar);
    ImGui::PopStyleVar();
    const auto& s = stage.theme.surfaces;
    const auto& notice = session.notice;
    const auto text =
        notice ? notice->text : hintFor(session.gesture, session.view, session.document());
    const auto right = figures(session, stage.scale);
    const float width = ImGui::CalcTextSize(right.c_str()).x;
    const float room = static_cast<float>(stage.rect.width) - width - stage.px(48);
    ImGui::PushStyleColor(ImGuiCol_Text, packed(!notice             ? s.quiet
                                                : notice->isProblem ? s.warning
                                                                    : s.text));
    const auto shown = cutToFit(text, room);
    ImGui::TextUnformatted(shown.c_str());
    ImGui::PopStyleColor();
    const bool cut = shown != text;
    if (cut && !notice) {
        explain(text);
    }
    ImGui::SameLine(static_cast<float>(stage.rect.width) - width - stage.px(14));
    ImGui::TextDisabled("%s", right.c_str());
    ImGui::End();
    if (cut && notice) {
        drawWhole(*notice, stage);
    }
}

void beginPanel(const char* name, const Stage& stage, int moreFlags) {
    ImGui::SetNextWindowPos(
        {static_cast<float>(stage.rect.left), static_cast<float>(stage.rect.top)});
    ImGui::SetNextWindowSize(
        {static_cast<float>(stage.rect.width), static_cast<float>(stage.rect.height)});
    ImGui::Begin(name, nullptr,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoBringToFrontOnFocus | moreFlags);
}

} // namespace splineloft::ui
