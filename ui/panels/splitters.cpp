#include "ui/panels/panels.h"

#include <imgui.h>

namespace splineloft::ui {
namespace {

constexpr double reach = 3.5; // design pixels to either side of an edge that take the pointer

/// Which way an edge moves.
enum class Way { across, along };

/// An edge under the pointer, in a little window of its own over the two panels beside it.
struct Splitter {
    const char* name;
    Way way;
    ScreenRect rect;
};

/// What the hand does to it: the pointer's place while it drags, or a double click.
struct Handled {
    std::optional<ScreenPoint> to;
    bool reset = false;
};

Handled handle(const Splitter& splitter, const Stage& window) {
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1, 1});
    beginPanel(splitter.name, {window.theme, window.scale, splitter.rect},
               ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoScrollbar);
    ImGui::PopStyleVar(2);
    const auto& r = splitter.rect;
    ImGui::InvisibleButton("edge", {static_cast<float>(r.width), static_cast<float>(r.height)});
    Handled handled;
    if (ImGui::IsItemHovered() || ImGui::IsItemActive()) {
        ImGui::SetMouseCursor(splitter.way == Way::across ? ImGuiMouseCursor_ResizeEW
                                                          : ImGuiMouseCursor_ResizeNS);
        const auto middle = [](double from, double size) {
            return static_cast<float>(from + size / 2);
        };
        const auto line = packed(window.theme.surfaces.accent);
        auto& list = *ImGui::GetWindowDrawList();
        if (splitter.way == Way::across) {
            const float x = middle(r.left, r.width);
            list.AddLine({x, static_cast<float>(r.top)}, {x, static_cast<float>(r.bottom())}, line,
                         window.px(2));
        } else {
            const float y = middle(r.top, r.height);
            list.AddLine({static_cast<float>(r.left), y}, {static_cast<float>(r.right()), y}, line,
                         window.px(2));
        }
    }
    if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(0)) {
        handled.reset = true;
    } else if (ImGui::IsItemActive() && ImGui::IsMouseDragging(0)) {
        const ImVec2 at = ImGui::GetIO().MousePos;
        handled.to = ScreenPoint{at.x, at.y};
    }
    ImGui::End();
    return handled;
}

} // namespace

void drawSplitters(View& view, const Layout& layout, const Screen& screen, const Theme& theme) {
    const double half = reach * screen.scale;
    const Stage window{theme, screen.scale, {}};
    const auto& strip = layout.strip;
    const auto& inspector = layout.inspector;
    if (inspector.width > 0) {
        const Splitter edge{"beside the inspector",
                            Way::across,
                            {inspector.left - half, inspector.top, 2 * half, inspector.height}};
        const auto hand = handle(edge, window);
        if (hand.reset) {
            view.inspector = usualInspector;
        } else if (hand.to) {
            view.inspector =
                inspectorRange(screen).limited((screen.width - hand.to->x) / screen.scale);
        }
    }
    if (strip.height > 0) {
        const Splitter edge{
            "above the strip", Way::along, {strip.left, strip.top - half, strip.width, 2 * half}};
        const auto hand = handle(edge, window);
        if (hand.reset) {
            view.strip = usualStrip;
        } else if (hand.to) {
            view.strip = stripRange(screen).limited((strip.bottom() - hand.to->y) / screen.scale);
        }
    }
}

} // namespace splineloft::ui
