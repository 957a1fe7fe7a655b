#include "core/document/edits.h"
#include "core/spline/catalog.h"
#include "ui/canvas/wording.h"
#include "ui/panels/panels.h"
#include "ui/widgets.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <utility>

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
        ImGui::AlignTextToFramePadding();
        heading("Curves");
        const std::string words = "+ New";
        ImGui::SameLine(ImGui::GetCursorStartPos().x + ImGui::GetContentRegionAvail().x -
                        quietButtonWidth(words, stage_));
        if (quietButton(words.c_str(), view_.tool == Tool::newCurve, stage_)) {
            view_.tool = Tool::newCurve;
        }
        explain("Click on the canvas to begin another curve (Shift+P)");
        ImGui::SetCursorPosY(ImGui::GetCursorPosY() - stage_.px(6)); // the rows have their own air
        if (auto edit = drawCurves(session_, view_, stage_)) {
            edit_ = std::move(edit);
        }
        ImGui::Dummy({0, stage_.px(8)});
    }

    /// All that can be said and set of a curve; said only, where it is locked.
    void activeCurve(const Study& study) {
        const bool locked = session_.document().curves[view_.activeCurve].look.locked;
        if (locked) {
            quietText("Locked: nothing here can be changed until its lock is opened.", stage_);
            ImGui::Spacing();
        }
        ImGui::BeginDisabled(locked);
        family(study);
        parameters(study);
        ends(study);
        ImGui::EndDisabled();
        traits(study);
        axes(study);
        ImGui::BeginDisabled(locked);
        points(study);
        ImGui::EndDisabled();
    }

    /// For the first curve, while there is none.
    void noCurve() {
        quietText("No curve yet. Press P and click on the canvas to lay down points, or open a "
                  "file with Ctrl+O.",
                  stage_);
        ImGui::Spacing();
        if (const auto* chosen = familyList(*findFamily(view_.firstFamily))) {
            view_.firstFamily = chosen->id;
        }
    }

    void family(const Study& study) {
        if (const auto* chosen = familyList(study.family())) {
            commit(setFamily(settled(), view_.activeCurve, chosen->id),
                   "Draw as " + std::string(chosen->name));
        }
    }

    /// The list of families, and what the present one is about; the one that was chosen, or null.
    const Family* familyList(const Family& now) {
        const Family* chosen = nullptr;
        heading("Family");
        const std::string name(now.name);
        ImGui::PushFont(font(Face::bold));
        ImGui::SetNextItemWidth(-1);
        if (ImGui::BeginCombo("##family", name.c_str(), ImGuiComboFlags_HeightLargest)) {
            ImGui::PushFont(font(Face::regular)); // a font is popped in the window that pushed it
            for (const auto& family : catalog()) {
                const std::string option(family.name);
                if (ImGui::Selectable(option.c_str(), family.id == now.id)) {
                    chosen = &family;
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
        return chosen;
    }

    void parameters(const Study& study) {
        for (const auto& parameter : study.family().parameters) {
            const ImVec2 corner = ImGui::GetCursorPos();
            const bool local = study.curve().local.contains(std::string(parameter.key));
            const auto chosen = local ? selectedPoints() : std::vector<std::size_t>();
            const auto turned =
                parameterSlider(parameter, valueOf(study.curve(), parameter, chosen), stage_);
            if (turned) {
                const auto name = "Set " + std::string(parameter.label);
                const auto curve = view_.activeCurve;
                edit_ = local
                            ? Edit{setLocal(settled(), curve, parameter.key, chosen, turned->value),
                                   turned->phase, name + " of " + wordsOf(chosen)}
                            : Edit{setParameter(settled(), curve, parameter.key, turned->value),
                                   turned->phase, name};
            }
            if (parameter.local) {
                perPoint(study, parameter, chosen, corner);
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
            if (!curve.knots.empty()) {
                ImGui::SameLine(stage_.px(62));
                quietText(ownKnots(curve), stage_);
                explain("The first and last of its knots say how it begins and stops. Another end "
                        "takes their place.");
            }
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
        } else if (!curve.knots.empty()) {
            ImGui::AlignTextToFramePadding();
            ImGui::TextUnformatted("Knots");
            ImGui::SameLine(stage_.px(62));
            quietText(ownKnots(curve), stage_);
            ImGui::SameLine(0, stage_.px(10));
            if (quietButton("drop", true, stage_)) {
                commit(setEnds(settled(), view_.activeCurve, accepted.front()), "Drop the knots");
            }
            explain("Knots from the spacing above take their place.");
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
        heading("Points");
        if (auto edit = drawPoints(session_, view_, study, stage_)) {
            edit_ = std::move(edit);
        }
    }

  private:
    const Document& settled() const { return session_.history.settled(); }

    void commit(Document next, std::string label) {
        edit_ = Edit{std::move(next), Phase::commit, std::move(label)};
    }

    void heading(const char* text) { quietText(text, stage_); }

    /// The selected control points of the active curve.
    std::vector<std::size_t> selectedPoints() const {
        std::vector<std::size_t> points;
        for (const auto& id : view_.selection) {
            if (id.curve == view_.activeCurve && id.part == Part::point) {
                points.push_back(id.index);
            }
        }
        return points;
    }

    /// Those points; none stands for all of them.
    static std::string wordsOf(const std::vector<std::size_t>& points) {
        return points.empty()       ? "all points"
               : points.size() == 1 ? plainPointName(points.front())
                                    : std::to_string(points.size()) + " points";
    }

    /// What a parameter's slider shows: where it is local, the value at the first of the points.
    static double valueOf(const Curve& curve, const Parameter& parameter,
                          const std::vector<std::size_t>& points) {
        const auto local = curve.local.find(std::string(parameter.key));
        return local == curve.local.end() ? parameterOf(curve, parameter.key)
                                          : local->second.at(points.empty() ? 0 : points.front());
    }

    /// Whether a local parameter has several values at those points.
    static bool differ(const Study& study, const Parameter& parameter,
                       const std::vector<std::size_t>& points) {
        const auto& values = study.curve().local.at(std::string(parameter.key));
        const double first = values.at(points.empty() ? 0 : points.front());
        return points.empty()
                   ? std::ranges::any_of(values, [&](double v) { return v != first; })
                   : std::ranges::any_of(points, [&](auto i) { return values.at(i) != first; });
    }

    /// Beside the name of a parameter that may be local: whether it is, and at which points the
    /// slider sets it.
    void perPoint(const Study& study, const Parameter& parameter,
                  const std::vector<std::size_t>& points, ImVec2 corner) {
        const bool local = study.curve().local.contains(std::string(parameter.key));
        const ImVec2 below = ImGui::GetCursorPos();
        const bool mixed = local && differ(study, parameter, points);
        const auto words = local ? wordsOf(points) : std::string("per point");
        const auto shown = mixed ? std::string("mixed values") : words;
        const float right = below.x + ImGui::GetContentRegionAvail().x - stage_.px(98);
        ImGui::SetCursorPos({right - quietButtonWidth(shown, stage_), corner.y});
        const auto name = std::string(parameter.label);
        if (quietButton((shown + "###per " + std::string(parameter.key)).c_str(), local, stage_)) {
            local ? commit(makeGlobal(settled(), view_.activeCurve, parameter.key),
                           name + " for the whole curve")
                  : commit(makeLocal(settled(), view_.activeCurve, parameter.key),
                           name + " per point");
        }
        explain(local ? (mixed ? "Their values differ; this is that of the first. " : "") +
                            ("The slider sets " + words) +
                            ". Click for one value for the whole curve again."
                      : "Click for a value at each point.");
        ImGui::SetCursorPos(below);
    }

    static std::string ownKnots(const Curve& curve) {
        return "own knots (" + std::to_string(curve.knots.size()) + ")";
    }

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
            while (last + 1 < t.joints.size() && readAlike(t.joints[i], t.joints[last + 1])) {
                ++last;
            }
            const auto from = significant(t.joints[i].t, 4);
            const auto to = significant(t.joints[last].t, 4);
            quietText("t = " + from + (last > i ? " … " + to : "") + ":  " + words, stage_);
            i = last + 1;
        }
    }

    const Session& session_;
    View& view_;
    const Stage& stage_;
    std::optional<Edit> edit_;
};

} // namespace

/// The inspector's stage without its foot, and the foot.
static std::pair<Stage, Stage> divided(const Stage& stage, double foot) {
    const auto [left, top, width, height] = stage.rect;
    return {Stage{stage.theme, stage.scale, {left, top, width, height - foot}},
            Stage{stage.theme, stage.scale, {left, top + height - foot, width, foot}}};
}

std::optional<Edit> drawInspector(const Session& session, View& view, const Stage& stage) {
    // At the foot the numbers of a selection move nothing when they come and go, least of all the
    // row that was clicked for it.
    const auto box = boxOfSelection(session.document(), view);
    const double foot = box ? std::min(selectionHeight(stage), stage.rect.height / 2) : 0;
    const auto [upper, lower] = divided(stage, foot);
    beginPanel("inspector", upper);
    Inspector inspector(session, view, upper);
    if (const Study* study = session.active()) {
        inspector.curves();
        inspector.activeCurve(*study);
    } else {
        inspector.noCurve();
    }
    ImGui::End();
    auto edit = box ? drawSelection(session, view, *box, lower) : std::nullopt;
    return edit ? edit : inspector.edit();
}

} // namespace splineloft::ui
