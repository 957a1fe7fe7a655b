#include "core/document/edits.h"
#include "core/spline/catalog.h"
#include "ui/canvas/wording.h"
#include "ui/lettering.h"
#include "ui/panels/panels.h"
#include "ui/widgets.h"

#include <imgui.h>

#include <algorithm>
#include <array>

namespace splineloft::ui {
namespace {

constexpr int mostJointLines = 6;

/// One inspector being drawn; collects what the person did.
class Inspector {
  public:
    Inspector(const Session& session, View& view, const Stage& stage)
        : session_(session), view_(view), stage_(stage) {}

    std::optional<Edit> edit() { return std::move(edit_); }

    void curves() {
        const auto& all = session_.document().curves;
        if (all.size() < 2) {
            return;
        }
        heading("Curves");
        for (std::size_t i = 0; i < all.size(); ++i) {
            ImGui::PushID(static_cast<int>(i));
            const auto label = all[i]->name + "##curve";
            if (ImGui::Selectable(label.c_str(), i == view_.activeCurve)) {
                view_.activeCurve = i;
                view_.selection.clear();
                view_.cursor = {};
            }
            ImGui::PopID();
        }
        ImGui::Spacing();
    }

    void family(const Study& study) {
        heading("Family");
        const auto& now = study.family();
        const std::string name(now.name);
        ImGui::PushFont(font(Face::bold));
        ImGui::SetNextItemWidth(-1);
        if (ImGui::BeginCombo("##family", name.c_str(), ImGuiComboFlags_HeightLargest)) {
            ImGui::PushFont(font(Face::regular)); // a font is popped in the window that pushed it
            for (const auto& family : catalog()) {
                const std::string option(family.name);
                if (ImGui::Selectable(option.c_str(), family.id == now.id)) {
                    commit(setFamily(settled(), view_.activeCurve, family.id), "Draw as " + option);
                }
                explain(std::string(family.summary));
            }
            ImGui::PopFont();
            ImGui::EndCombo();
        }
        ImGui::PopFont();
        quietText(std::string(now.summary) +
                      (now.source.empty() ? "" : "\n" + std::string(now.source)),
                  stage_);
        ImGui::Spacing();
    }

    void parameters(const Study& study) {
        const auto values = parametersOf(study.curve());
        for (std::size_t i = 0; i < values.size(); ++i) {
            const auto& parameter = study.family().parameters[i];
            const auto turned = parameterSlider(parameter, values[i], stage_);
            if (turned) {
                edit_ =
                    Edit{setParameter(settled(), view_.activeCurve, parameter.key, turned->value),
                         turned->phase, "Set " + std::string(parameter.label)};
            }
            ImGui::Spacing();
        }
    }

    void ends(const Study& study) {
        const Curve& curve = study.curve();
        const auto& accepted = study.family().ends;
        if (accepted.size() > 1 && !curve.closed) {
            std::vector<std::string_view> names;
            for (const auto end : accepted) {
                names.push_back(nameOf(end));
            }
            const auto chosen = std::ranges::find(accepted, curve.ends) - accepted.begin();
            ImGui::AlignTextToFramePadding();
            ImGui::TextUnformatted("Ends");
            ImGui::PushFont(font(Face::small));
            if (names.size() < 4) {
                ImGui::SameLine(stage_.px(62));
            }
            const auto clicked = choiceOf("ends", names, static_cast<int>(chosen), stage_,
                                          ImGui::GetContentRegionAvail().x);
            ImGui::PopFont();
            if (clicked) {
                const auto index = static_cast<std::size_t>(*clicked);
                commit(setEnds(settled(), view_.activeCurve, accepted[index]),
                       "Ends " + std::string(names[index]));
            }
        }
        bool closed = curve.closed;
        if (!study.family().closable) {
            quietText("This family is always open.", stage_);
        } else if (toggle("Closed", closed, stage_)) {
            commit(setClosed(settled(), view_.activeCurve, closed),
                   closed ? "Close the curve" : "Open the curve");
        }
        ImGui::Spacing();
    }

    void traits(const Study& study) {
        if (study.pieces().empty()) {
            return;
        }
        const auto& t = study.traits();
        static constexpr std::array<const char*, 4> orders = {"⁻¹", "⁰", "¹", "²"};
        const auto order = [](int n) { return orders[static_cast<std::size_t>(n + 1)]; };
        std::vector<Chip> row = {{"through points", t.throughAll}, {"in hull", t.inHull}};
        row.push_back({t.global ? "every point moves all"
                                : "moves ≤ " + std::to_string(t.reach) +
                                      (t.reach == 1 ? " piece" : " pieces")});
        if (!t.joints.empty()) {
            // Beyond the second derivative nothing is measured.
            const bool more = study.pieces().degree() > 3;
            row.push_back({(more && t.c == 2 ? "≥ C" : "C") + std::string(order(t.c))});
            row.push_back({(more && t.g == 2 ? "≥ G" : "G") + std::string(order(t.g))});
        }
        chips(row, stage_);
        if (!study.measuredWhole()) {
            quietText("All but the joints is measured on the first points of many.", stage_);
        }
        joints(t);
        ImGui::Spacing();
    }

    /// Which coordinates the canvas shows, where there are more than two.
    void axes(const Study& study) {
        const auto& names = study.curve().coordinates;
        if (names.size() < 3) {
            return;
        }
        heading("Canvas shows");
        const auto pick = [&](const char* label, int& axis) {
            ImGui::SetNextItemWidth(stage_.px(86));
            const auto now = std::min(static_cast<std::size_t>(axis), names.size() - 1);
            if (ImGui::BeginCombo(label, names[now].c_str())) {
                for (std::size_t i = 0; i < names.size(); ++i) {
                    if (ImGui::Selectable(names[i].c_str(), i == now)) {
                        axis = static_cast<int>(i);
                        view_.fitPending = true;
                    }
                }
                ImGui::EndCombo();
            }
        };
        pick("across", view_.axes.across);
        ImGui::SameLine(0, stage_.px(14));
        pick("up", view_.axes.up);
        ImGui::Spacing();
    }

    void points(const Study& study) {
        const Curve& curve = study.curve();
        const int dimension = curve.points.dimension();
        heading("Points");
        // Up to three coordinates share the width; more are scrolled through.
        const bool wide = dimension > 3;
        const auto rows = static_cast<float>(curve.points.size() + curve.tangents.size() + 1);
        const float height =
            wide ? std::min(rows * stage_.px(25) + stage_.px(14), stage_.px(420)) : 0;
        if (!ImGui::BeginTable("points", dimension + 1,
                               ImGuiTableFlags_RowBg |
                                   (wide ? ImGuiTableFlags_ScrollX | ImGuiTableFlags_ScrollY |
                                               ImGuiTableFlags_SizingFixedFit
                                         : ImGuiTableFlags_SizingStretchSame),
                               {0, height})) {
            return;
        }
        ImGui::TableSetupScrollFreeze(wide ? 1 : 0, wide ? 1 : 0);
        ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthFixed, stage_.px(50));
        for (const auto& name : curve.coordinates) {
            ImGui::TableSetupColumn(name.c_str(), 0, wide ? stage_.px(72) : 0);
        }
        header(curve);
        ImGui::PushStyleColor(ImGuiCol_FrameBg, IM_COL32(0, 0, 0, 0));
        ImGui::PushStyleVar(ImGuiStyleVar_FrameBorderSize, 0);
        ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {stage_.px(4), stage_.px(2)});
        ImGuiListClipper clipper;
        clipper.Begin(static_cast<int>(curve.points.size() + curve.tangents.size()));
        while (clipper.Step()) {
            for (int row = clipper.DisplayStart; row < clipper.DisplayEnd; ++row) {
                const auto index = static_cast<std::size_t>(row);
                const auto n = curve.points.size();
                pointRow(curve, index < n ? PointId{view_.activeCurve, index, Part::point}
                                          : PointId{view_.activeCurve, index - n, Part::tangent});
            }
        }
        ImGui::PopStyleVar(2);
        ImGui::PopStyleColor();
        ImGui::EndTable();
    }

  private:
    const Document& settled() const { return session_.history.settled(); }

    void commit(Document next, std::string label) {
        edit_ = Edit{std::move(next), Phase::commit, std::move(label)};
    }

    void heading(const char* text) { quietText(text, stage_); }

    /// The continuity of each joint, in words.
    void joints(const Traits& t) {
        if (t.joints.empty()) {
            return;
        }
        ImGui::Spacing();
        heading("Joints");
        int lines = 0;
        for (std::size_t i = 0; i < t.joints.size(); ++lines) {
            if (lines == mostJointLines) {
                const auto rest = std::to_string(t.joints.size() - i);
                quietText("and " + rest + " more: rest the pointer on a joint to read it", stage_);
                return;
            }
            // Joints in a row that are alike share a line.
            const auto words = describe(t.joints[i]);
            std::size_t last = i;
            while (last + 1 < t.joints.size() && describe(t.joints[last + 1]) == words) {
                ++last;
            }
            const auto from = significant(t.joints[i].t, 4);
            const auto to = significant(t.joints[last].t, 4);
            quietText("t = " + from + (last > i ? " … " + to : "") + ":  " + words, stage_);
            i = last + 1;
        }
    }

    void header(const Curve& curve) {
        ImGui::TableNextRow();
        for (std::size_t c = 0; c < curve.coordinates.size(); ++c) {
            ImGui::TableSetColumnIndex(static_cast<int>(c) + 1);
            ImGui::TextDisabled(" %s", curve.coordinates[c].c_str());
        }
    }

    void pointRow(const Curve& curve, const PointId& id) {
        const bool tangent = id.part == Part::tangent;
        const auto& table = tangent ? curve.tangents : curve.points;
        ImGui::TableNextRow();
        ImGui::TableSetColumnIndex(0);
        ImGui::PushID(tangent ? 1 : 0);
        ImGui::PushID(static_cast<int>(id.index));
        const ImVec2 at = ImGui::GetCursorScreenPos();
        if (view_.selection.contains(id)) {
            ImGui::TableSetBgColor(ImGuiTableBgTarget_RowBg1,
                                   packed(stage_.theme.surfaces.accentSoft));
        }
        if (ImGui::Selectable("##row", false, 0, {0, stage_.px(20)})) {
            if (!ImGui::GetIO().KeyShift) {
                view_.selection.clear();
            }
            view_.selection.insert(id);
        }
        auto& list = *ImGui::GetWindowDrawList();
        const Colour colour = colourOf(stage_.theme, {Role::control, static_cast<int>(id.index)});
        list.AddCircleFilled({at.x + stage_.px(7), at.y + stage_.px(10)}, stage_.px(5),
                             packed(colour));
        drawMath(list, {at.x + stage_.px(18), at.y + stage_.px(1)}, stage_.theme.surfaces.text,
                 (tangent ? "T_" : "P_") + std::to_string(id.index), Face::regular);
        for (int c = 0; c < table.dimension(); ++c) {
            ImGui::TableSetColumnIndex(c + 1);
            ImGui::PushID(c);
            Point place = table.at(id.index);
            if (const auto entered = numberField("##value", place[c], -1)) {
                place[c] = *entered;
                commit(setPoint(settled(), id, place),
                       "Set " + curve.coordinates[static_cast<std::size_t>(c)] + " of " +
                           plainPointName(id.index));
            }
            ImGui::PopID();
        }
        ImGui::PopID();
        ImGui::PopID();
    }

    const Session& session_;
    View& view_;
    const Stage& stage_;
    std::optional<Edit> edit_;
};

} // namespace

std::optional<Edit> drawInspector(const Session& session, View& view, const Stage& stage) {
    beginPanel("inspector", stage);
    Inspector inspector(session, view, stage);
    if (const Study* study = session.active()) {
        inspector.curves();
        inspector.family(*study);
        inspector.parameters(*study);
        inspector.ends(*study);
        inspector.traits(*study);
        inspector.axes(*study);
        inspector.points(*study);
    } else {
        quietText(
            "No curve yet. Press P and click on the canvas to lay down points, or open a file "
            "with Ctrl+O.",
            stage);
    }
    ImGui::End();
    return inspector.edit();
}

} // namespace splineloft::ui
