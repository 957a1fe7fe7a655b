// The numbers of one point, typed in beside it.
#include "core/document/edits.h"
#include "ui/canvas/point_values.h"
#include "ui/canvas/wording.h"
#include "ui/imgui_compat.h"
#include "ui/panels/panels.h"
#include "ui/widgets.h"

#include <imgui.h>

#include <algorithm>

namespace splineloft::ui {
namespace {

// Design pixels.
constexpr double aside = 20; // of the point
constexpr double entryWidth = 128;
constexpr double windowWidth = 190; // about
constexpr double entryHeight = 32;  // about

/// Where the window stands: beside the point, and within the canvas.
ImVec2 cornerFor(ScreenPoint point, std::size_t rows, const Stage& stage) {
    const auto& r = stage.rect;
    const double height = (static_cast<double>(rows) * entryHeight + 64) * stage.scale;
    const double x = std::clamp(point.x + aside * stage.scale, r.left,
                                std::max(r.right() - windowWidth * stage.scale, r.left));
    const double y =
        std::clamp(point.y + aside * stage.scale, r.top, std::max(r.bottom() - height, r.top));
    return {static_cast<float>(x), static_cast<float>(y)};
}

std::optional<double> row(const std::string& label, double value, const Stage& stage) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(label.c_str());
    ImGui::SameLine(stage.px(48));
    ImGui::PushID(label.c_str());
    const auto entered = numberField("##value", value, stage.px(entryWidth));
    ImGui::PopID();
    return entered;
}

/// The rows of one point; an edit where a number was entered.
std::optional<Edit> rows(const Session& session, const PointId& id, const Stage& stage) {
    std::optional<Edit> edit;
    const Document& settled = session.history.settled();
    const Curve& curve = *settled.curves[id.curve];
    for (int c = 0; c < curve.points.dimension(); ++c) {
        const auto& name = curve.coordinates[static_cast<std::size_t>(c)];
        Point place = curve.points.at(id.index);
        if (c == 0 && ImGui::IsWindowAppearing()) {
            ImGui::SetKeyboardFocusHere();
        }
        if (const auto entered = row(name, place[c], stage)) {
            place[c] = *entered;
            edit = Edit{setPoint(settled, id, place), Phase::commit,
                        "Set " + name + " of " + plainPointName(id.index)};
        }
    }
    for (const auto& value : pointValuesOf(curve)) {
        const std::string symbol(value.parameter.symbol);
        if (const auto entered = row(symbol, valueAt(curve, value, id.index), stage)) {
            edit = Edit{withValueAt(settled, id.curve, value, id.index, *entered), Phase::commit,
                        settingOf(value, id.index)};
        }
    }
    return edit;
}

} // namespace

std::optional<Edit> drawExactEntry(const Session& session, View& view, const Stage& stage) {
    const auto id = view.exactEntry;
    if (!id) {
        return std::nullopt;
    }
    const Viewport viewport{view.camera, stage.rect};
    const Curve& curve = *session.history.settled().curves[id->curve];
    const ScreenPoint at = viewport.toScreen(CurvePlaces(curve, view.axes).point(id->index));
    const auto count = curve.coordinates.size() + pointValuesOf(curve).size();
    ImGui::SetNextWindowPos(cornerFor(at, count, stage));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, stage.px(1));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, stage.px(6));
    ImGui::Begin("exact entry", nullptr,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_AlwaysAutoResize |
                     ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings);
    ImGui::PopStyleVar(2);
    const bool appearing = ImGui::IsWindowAppearing();
    quietText(plainPointName(id->index) + " · Tab goes on, Enter ends", stage);
    auto edit = rows(session, *id, stage);
    const bool ended = ImGui::IsKeyPressed(enterKey()) || ImGui::IsKeyPressed(escapeKey()) ||
                       !ImGui::IsWindowFocused();
    ImGui::End();
    if (ended && !appearing) {
        view.exactEntry.reset();
    }
    return edit;
}

} // namespace splineloft::ui
