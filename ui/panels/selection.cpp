// Several selected points at once: where their box is and how large, to be typed in; and turning
// and scaling by exact numbers.
#include "core/document/edits.h"
#include "ui/canvas/gizmo.h"
#include "ui/canvas/hints.h"
#include "ui/panels/panels.h"
#include "ui/widgets.h"

#include <imgui.h>

#include <array>
#include <numbers>

namespace splineloft::ui {
namespace {

/// A field of the section, and what a number entered there does to the box.
struct Field {
    const char* label;
    const char* deed;
    double value;
    PlaneMap (*map)(const PlaneBox& box, double number);
    bool possible = true;
};

PlanePlace middleOf(const PlaneBox& box) {
    return {box.middle().x, box.middle().y};
}

std::array<Field, 6> fieldsOf(const PlaneBox& box) {
    return {Field{"x", "Move ", box.middle().x,
                  [](const PlaneBox& b, double x) { return PlaneMap::moved(x - b.middle().x, 0); }},
            Field{"y", "Move ", box.middle().y,
                  [](const PlaneBox& b, double y) { return PlaneMap::moved(0, y - b.middle().y); }},
            Field{"width", "Scale ", box.width(),
                  [](const PlaneBox& b, double width) {
                      return PlaneMap::scaledAbout(middleOf(b), width / b.width(), 1);
                  },
                  box.width() > 0},
            Field{"height", "Scale ", box.height(),
                  [](const PlaneBox& b, double height) {
                      return PlaneMap::scaledAbout(middleOf(b), 1, height / b.height());
                  },
                  box.height() > 0},
            Field{"turn °", "Turn ", 0,
                  [](const PlaneBox& b, double degrees) {
                      return PlaneMap::rotatedAbout(middleOf(b), degrees * std::numbers::pi / 180);
                  }},
            Field{"scale %", "Scale ", 100, [](const PlaneBox& b, double percent) {
                      return PlaneMap::scaledAbout(middleOf(b), percent / 100, percent / 100);
                  }}};
}

} // namespace

double selectionHeight(const Stage& stage) {
    const ImGuiStyle& style = ImGui::GetStyle();
    const double rows = 3 * (ImGui::GetFrameHeight() + style.ItemSpacing.y);
    return 2 * style.WindowPadding.y + font(Face::small)->FontSize + rows + stage.px(2);
}

std::optional<Edit> drawSelection(const Session& session, const View& view, const PlaneBox& box,
                                  const Stage& stage) {
    beginPanel("selection", stage);
    const auto top = ImGui::GetWindowPos();
    ImGui::GetWindowDrawList()->AddLine(top, {top.x + ImGui::GetWindowWidth(), top.y},
                                        packed(stage.theme.surfaces.line), stage.px(1));
    const auto& settled = session.history.settled();
    const auto& ids = view.selection.ids();
    quietText("Selection: " + nameOf(settled, ids) + ", about their middle", stage);
    std::optional<Edit> edit;
    const float half = ImGui::GetContentRegionAvail().x / 2;
    int column = 0;
    for (const auto& field : fieldsOf(box)) {
        if (column % 2 == 1) {
            ImGui::SameLine(ImGui::GetCursorStartPos().x + half + stage.px(6));
        }
        const float left = ImGui::GetCursorPosX();
        ImGui::AlignTextToFramePadding();
        ImGui::TextUnformatted(field.label);
        ImGui::SameLine(left + stage.px(56));
        ImGui::PushID(field.label);
        ImGui::BeginDisabled(!field.possible);
        const auto entered = numberField("##selection", field.value, half - stage.px(62));
        ImGui::EndDisabled();
        ImGui::PopID();
        if (entered) { // what is no number is refused where it would have gone
            const PlaneMap map = field.map(box, *entered);
            edit = Edit{transformPoints(settled, ids, map, view.axes.across, view.axes.up),
                        Phase::commit, field.deed + nameOf(settled, ids)};
        }
        ++column;
    }
    ImGui::End();
    return edit;
}

} // namespace splineloft::ui
