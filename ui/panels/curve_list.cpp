// The curves of the document, one row each: colour, name, whether it is seen and whether hands may
// touch it. Dragging a row draws its curve sooner or later.
#include "core/document/curve_edits.h"
#include "ui/imgui_compat.h"
#include "ui/panels/panels.h"
#include "ui/widgets.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

namespace splineloft::ui {
namespace {

// Design pixels.
constexpr double rowHeight = 26;
constexpr double iconWidth = 24;
constexpr double swatchSide = 14;

constexpr std::size_t mostRows = 8; // more of them scroll

ImVec2 middleOf(ImVec2 corner, ImVec2 size) {
    return {corner.x + size.x / 2, corner.y + size.y / 2};
}

/// An eye, closed by a stroke where the curve is hidden.
void drawEye(ImVec2 at, bool open, unsigned colour, const Stage& stage) {
    auto& list = *ImGui::GetWindowDrawList();
    const float half = stage.px(7);
    const float lid = stage.px(6.5);
    const float width = stage.px(1.4);
    const ImVec2 left{at.x - half, at.y};
    const ImVec2 right{at.x + half, at.y};
    list.AddBezierQuadratic(left, {at.x, at.y - lid}, right, colour, width);
    list.AddBezierQuadratic(left, {at.x, at.y + lid}, right, colour, width);
    if (open) {
        list.AddCircleFilled(at, stage.px(2.2), colour, 12);
    } else {
        list.AddLine({at.x - stage.px(5), at.y + stage.px(5)},
                     {at.x + stage.px(5), at.y - stage.px(5)}, colour, width);
    }
}

/// A padlock; its bow is out of the body where it is open.
void drawLock(ImVec2 at, bool locked, unsigned colour, const Stage& stage) {
    auto& list = *ImGui::GetWindowDrawList();
    const float half = stage.px(4.5);
    const float aside = locked ? 0 : stage.px(5);
    constexpr float turn = 3.14159265F;
    list.AddRectFilled({at.x - half, at.y - stage.px(0.5)}, {at.x + half, at.y + stage.px(6)},
                       colour, stage.px(1));
    list.PathArcTo({at.x + aside, at.y - stage.px(2)}, stage.px(3), -turn, 0, 12);
    list.PathLineTo({at.x + aside + stage.px(3), at.y});
    list.PathStroke(colour, 0, stage.px(1.4));
    list.AddLine({at.x + aside - stage.px(3), at.y - stage.px(2)},
                 {at.x + aside - stage.px(3), at.y}, colour, stage.px(1.4));
}

class CurveList {
  public:
    CurveList(const Session& session, View& view, const Stage& stage)
        : session_(session), view_(view), stage_(stage) {}

    void draw() {
        const auto count = session_.document().curves.size();
        ImGui::PushID("curves");
        ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {stage_.px(4), 0});
        const bool scrolls = count > mostRows;
        if (scrolls) {
            ImGui::BeginChild("rows", {0, static_cast<float>(mostRows) * stage_.px(rowHeight)});
        }
        for (std::size_t i = 0; i < count; ++i) {
            ImGui::PushID(static_cast<int>(i));
            row(i);
            ImGui::PopID();
        }
        if (scrolls) {
            ImGui::EndChild();
        }
        ImGui::PopStyleVar();
        ImGui::PopID();
    }

    std::optional<Edit> edit() { return std::move(edit_); }

  private:
    const CurveEntry& entry(std::size_t i) const { return session_.document().curves[i]; }
    const Document& settled() const { return session_.history.settled(); }

    void commit(Document next, const std::string& deed, std::size_t i) {
        edit_ = Edit{std::move(next), Phase::commit, deed + " " + entry(i)->name};
    }

    void setLook(std::size_t i, const Look& look, const std::string& deed) {
        commit(splineloft::setLook(settled(), i, look), deed, i);
    }

    void row(std::size_t i) {
        const ImVec2 corner = ImGui::GetCursorScreenPos();
        const float icons = 2 * (stage_.px(iconWidth) + stage_.px(4));
        swatch(i);
        ImGui::SameLine();
        const float room = ImGui::GetContentRegionAvail().x - icons;
        if (view_.renaming && view_.renaming->curve == i) {
            nameField(i, room);
        } else {
            name(i, room, corner.y);
        }
        ImGui::SameLine();
        eye(i);
        ImGui::SameLine();
        lock(i);
    }

    void swatch(std::size_t i) {
        const ImVec2 corner = ImGui::GetCursorScreenPos();
        const ImVec2 size{stage_.px(iconWidth), stage_.px(rowHeight)};
        if (ImGui::InvisibleButton("colour", size)) {
            ImGui::OpenPopup("colours");
        }
        explain("The colour of this curve");
        drawSwatch(middleOf(corner, size), entry(i).look.colour, ImGui::IsItemHovered());
        if (ImGui::BeginPopup("colours")) {
            colours(i);
            ImGui::EndPopup();
        }
    }

    void drawSwatch(ImVec2 at, int colour, bool lively) {
        const float half = stage_.px(swatchSide) / 2;
        auto& list = *ImGui::GetWindowDrawList();
        const ImVec2 from{at.x - half, at.y - half};
        const ImVec2 to{at.x + half, at.y + half};
        list.AddRectFilled(from, to, packed(colourOf(stage_.theme, {Role::curve, colour})),
                           stage_.px(3));
        if (lively) {
            list.AddRect(from, to, packed(stage_.theme.surfaces.text), stage_.px(3), 0,
                         stage_.px(1.5));
        }
    }

    void colours(std::size_t i) {
        for (int colour = 0; colour <= curveColours; ++colour) {
            ImGui::PushID(colour);
            const ImVec2 corner = ImGui::GetCursorScreenPos();
            const ImVec2 size{stage_.px(iconWidth), stage_.px(iconWidth)};
            if (ImGui::InvisibleButton("this", size)) {
                Look look = entry(i).look;
                look.colour = colour;
                setLook(i, look, "Colour");
                ImGui::CloseCurrentPopup();
            }
            drawSwatch(middleOf(corner, size), colour,
                       ImGui::IsItemHovered() || colour == entry(i).look.colour);
            ImGui::PopID();
            if (colour < curveColours) {
                ImGui::SameLine();
            }
        }
    }

    void nameField(std::size_t i, float width) {
        const auto typing = textField("##rename", entry(i)->name, width, !view_.renaming->begun);
        view_.renaming->begun = view_.renaming->begun || typing.begun;
        if (typing.over) {
            view_.renaming.reset();
        }
        if (typing.text && !typing.text->empty()) {
            commit(renameCurve(settled(), i, *typing.text), "Rename", i);
        }
    }

    void name(std::size_t i, float width, float top) {
        const auto& s = stage_.theme.surfaces;
        const ImVec2 corner = ImGui::GetCursorScreenPos();
        const bool seen = entry(i).look.visible;
        if (ImGui::Selectable("##name", i == view_.activeCurve, 0, {width, stage_.px(rowHeight)})) {
            turnTo(i);
        }
        const auto words = cutToFit(entry(i)->name, width - stage_.px(8));
        const float down = (stage_.px(rowHeight) - ImGui::GetTextLineHeight()) / 2;
        ImGui::GetWindowDrawList()->AddText({corner.x + stage_.px(4), corner.y + down},
                                            packed(seen ? s.text : s.quiet), words.c_str());
        explain(words == entry(i)->name ? "Double-click to rename it, drag to reorder"
                                        : entry(i)->name);
        if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(0) && !entry(i).look.locked) {
            view_.renaming = Renaming{i};
        }
        reorder(i, top);
    }

    void turnTo(std::size_t i) {
        if (i != view_.activeCurve) {
            view_.selection.clear();
        }
        activate(view_, i);
    }

    /// A row that is dragged shows where it would go, and goes there when it is let go of.
    void reorder(std::size_t from, float top) {
        const auto& io = ImGui::GetIO();
        const float height = stage_.px(rowHeight);
        const float rows = std::round((io.MousePos.y - io.MouseClickedPos[0].y) / height);
        const auto count = static_cast<float>(session_.document().curves.size());
        const auto own = static_cast<float>(from);
        const float target = std::clamp(own + rows, 0.0F, count - 1);
        if (target == own) {
            return;
        }
        if (ImGui::IsItemActive()) {
            const float y = top + (target - own + (target > own ? 1 : 0)) * height;
            const float left = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMin().x;
            const float right = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x;
            ImGui::GetWindowDrawList()->AddLine({left, y}, {right, y},
                                                packed(stage_.theme.surfaces.accent), stage_.px(2));
            if (ImGui::IsKeyPressed(escapeKey())) {
                releaseActiveWidget();
            }
        } else if (ImGui::IsItemDeactivated() && ImGui::IsMouseReleased(0)) {
            commit(moveCurve(settled(), from, static_cast<std::size_t>(target)), "Reorder", from);
        }
    }

    /// A sign to be clicked, quiet until the pointer is there.
    template <class Draw> bool icon(const char* id, bool telling, Draw draw) {
        const ImVec2 corner = ImGui::GetCursorScreenPos();
        const ImVec2 size{stage_.px(iconWidth), stage_.px(rowHeight)};
        const bool clicked = ImGui::InvisibleButton(id, size);
        const auto& s = stage_.theme.surfaces;
        draw(middleOf(corner, size), packed(telling || ImGui::IsItemHovered() ? s.text : s.quiet));
        return clicked;
    }

    void eye(std::size_t i) {
        Look look = entry(i).look;
        const bool seen = look.visible;
        if (icon("eye", !seen,
                 [&](ImVec2 at, unsigned colour) { drawEye(at, seen, colour, stage_); })) {
            look.visible = !seen;
            setLook(i, look, seen ? "Hide" : "Show");
        }
        explain(seen ? "Hide this curve" : "Show this curve");
    }

    void lock(std::size_t i) {
        Look look = entry(i).look;
        const bool locked = look.locked;
        if (icon("lock", locked,
                 [&](ImVec2 at, unsigned colour) { drawLock(at, locked, colour, stage_); })) {
            look.locked = !locked;
            setLook(i, look, locked ? "Unlock" : "Lock");
        }
        explain(locked ? "Let hands touch this curve again"
                       : "Lock this curve: it is seen, and no hand changes it");
    }

    const Session& session_;
    View& view_;
    const Stage& stage_;
    std::optional<Edit> edit_;
};

} // namespace

std::optional<Edit> drawCurves(const Session& session, View& view, const Stage& stage) {
    CurveList list(session, view, stage);
    list.draw();
    return list.edit();
}

} // namespace splineloft::ui
