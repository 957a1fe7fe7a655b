// The points of a curve in rows: coordinates, and beside them what else a control point has.
#include "core/document/edits.h"
#include "ui/canvas/point_values.h"
#include "ui/canvas/wording.h"
#include "ui/lettering.h"
#include "ui/panels/panels.h"
#include "ui/widgets.h"

#include <imgui.h>

#include <algorithm>
#include <vector>

namespace splineloft::ui {
namespace {

// So many columns share the width; more are scrolled through.
constexpr std::size_t mostCoordinatesAbreast = 3;
constexpr std::size_t mostColumnsAbreast = 4;

/// One table being drawn; keeps what the person did.
class PointsTable {
  public:
    PointsTable(const Session& session, View& view, const Study& study, const Stage& stage)
        : session_(session), view_(view), curve_(study.curve()), stage_(stage),
          values_(pointValuesOf(study.curve())) {}

    std::optional<Edit> draw() {
        const auto coordinates = curve_.coordinates.size();
        const auto columns = coordinates + values_.size();
        const bool wide = coordinates > mostCoordinatesAbreast || columns > mostColumnsAbreast;
        const auto rows = curve_.points.size() + curve_.tangents.size();
        const float height =
            wide ? std::min(static_cast<float>(rows + 1) * stage_.px(25) + stage_.px(14),
                            stage_.px(420))
                 : 0;
        if (!ImGui::BeginTable("points", static_cast<int>(columns) + 1,
                               ImGuiTableFlags_RowBg |
                                   (wide ? ImGuiTableFlags_ScrollX | ImGuiTableFlags_ScrollY |
                                               ImGuiTableFlags_SizingFixedFit
                                         : ImGuiTableFlags_SizingStretchSame),
                               {0, height})) {
            return std::nullopt;
        }
        ImGui::TableSetupScrollFreeze(wide ? 1 : 0, wide ? 1 : 0);
        ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthFixed, stage_.px(50));
        for (std::size_t c = 0; c < columns; ++c) {
            ImGui::TableSetupColumn(headingOf(c).c_str(), 0, wide ? stage_.px(72) : 0);
        }
        header(columns);
        ImGui::PushStyleColor(ImGuiCol_FrameBg, IM_COL32(0, 0, 0, 0));
        ImGui::PushStyleVar(ImGuiStyleVar_FrameBorderSize, 0);
        ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {stage_.px(4), stage_.px(2)});
        visibleRows(static_cast<int>(rows));
        ImGui::PopStyleVar(2);
        ImGui::PopStyleColor();
        ImGui::EndTable();
        return std::move(edit_);
    }

  private:
    const Document& settled() const { return session_.history.settled(); }

    void commit(Document next, std::string label) {
        edit_ = Edit{std::move(next), Phase::commit, std::move(label)};
    }

    std::string headingOf(std::size_t column) const {
        const auto coordinates = curve_.coordinates.size();
        return column < coordinates ? curve_.coordinates[column]
                                    : std::string(values_[column - coordinates].parameter.symbol);
    }

    void header(std::size_t columns) {
        ImGui::TableNextRow();
        for (std::size_t c = 0; c < columns; ++c) {
            ImGui::TableSetColumnIndex(static_cast<int>(c) + 1);
            ImGui::TextDisabled(" %s", headingOf(c).c_str());
        }
    }

    void visibleRows(int rows) {
        ImGuiListClipper clipper;
        clipper.Begin(rows);
        while (clipper.Step()) {
            for (int row = clipper.DisplayStart; row < clipper.DisplayEnd; ++row) {
                const auto index = static_cast<std::size_t>(row);
                const auto n = curve_.points.size();
                const bool tangent = index >= n;
                ImGui::TableNextRow();
                ImGui::PushID(tangent ? 1 : 0);
                ImGui::PushID(static_cast<int>(tangent ? index - n : index));
                const PointId id = tangent ? PointId{view_.activeCurve, index - n, Part::tangent}
                                           : PointId{view_.activeCurve, index, Part::point};
                name(id);
                coordinates(id);
                if (!tangent) {
                    values(index);
                }
                ImGui::PopID();
                ImGui::PopID();
            }
        }
    }

    /// The point's mark and name; a click selects it, with Shift it adds it or takes it away.
    void name(const PointId& id) {
        ImGui::TableSetColumnIndex(0);
        const ImVec2 at = ImGui::GetCursorScreenPos();
        if (view_.selection.contains(id)) {
            ImGui::TableSetBgColor(ImGuiTableBgTarget_RowBg1,
                                   packed(stage_.theme.surfaces.accentSoft));
        }
        if (ImGui::Selectable("##row", false, 0, {0, stage_.px(20)})) {
            const bool keeps = ImGui::GetIO().KeyShift;
            if (!keeps) {
                view_.selection.clear();
            }
            if (!keeps || !view_.selection.contains(id)) {
                view_.selection.insert(id);
            } else {
                view_.selection.erase(id);
            }
        }
        auto& list = *ImGui::GetWindowDrawList();
        const Colour colour = colourOf(stage_.theme, {Role::control, static_cast<int>(id.index)});
        list.AddCircleFilled({at.x + stage_.px(7), at.y + stage_.px(10)}, stage_.px(5),
                             packed(colour));
        drawMath(list, {at.x + stage_.px(18), at.y + stage_.px(1)}, stage_.theme.surfaces.text,
                 (id.part == Part::tangent ? "T_" : "P_") + std::to_string(id.index),
                 Face::regular);
    }

    /// The field of one cell, in the column after `column` others.
    static std::optional<double> cell(std::size_t column, double value) {
        ImGui::TableSetColumnIndex(static_cast<int>(column) + 1);
        ImGui::PushID(static_cast<int>(column));
        const auto entered = numberField("##value", value, -1);
        ImGui::PopID();
        return entered;
    }

    void coordinates(const PointId& id) {
        const auto& table = id.part == Part::tangent ? curve_.tangents : curve_.points;
        for (int c = 0; c < table.dimension(); ++c) {
            const auto column = static_cast<std::size_t>(c);
            Point place = table.at(id.index);
            if (const auto entered = cell(column, place[c])) {
                place[c] = *entered;
                commit(setPoint(settled(), id, place),
                       "Set " + curve_.coordinates[column] + " of " + plainPointName(id.index));
            }
        }
    }

    /// Its weight and local parameters.
    void values(std::size_t point) {
        for (std::size_t k = 0; k < values_.size(); ++k) {
            const auto entered =
                cell(curve_.coordinates.size() + k, valueAt(curve_, values_[k], point));
            if (entered) {
                commit(withValueAt(settled(), view_.activeCurve, values_[k], point, *entered),
                       settingOf(values_[k], point));
            }
        }
    }

    const Session& session_;
    View& view_;
    const Curve& curve_;
    const Stage& stage_;
    std::vector<PointValue> values_;
    std::optional<Edit> edit_;
};

} // namespace

std::optional<Edit> drawPoints(const Session& session, View& view, const Study& study,
                               const Stage& stage) {
    return PointsTable(session, view, study, stage).draw();
}

} // namespace splineloft::ui
