#include "ui/panels/panels.h"

#include <imgui.h>

#include <cmath>

namespace splineloft::ui {
namespace {

constexpr double zoomPerNotch = 1.15;

/// What a raw event means on the canvas, if anything.
std::optional<PointerEvent> pointerEvent(const InputEvent& event, ScreenPoint at, Modifiers held) {
    if (const auto* moved = std::get_if<PointerMoved>(&event)) {
        return PointerEvent{PointerEvent::Kind::move, {moved->x, moved->y}, Button::left, held};
    }
    if (const auto* button = std::get_if<PointerButton>(&event)) {
        PointerEvent result{button->down ? PointerEvent::Kind::press : PointerEvent::Kind::release,
                            at, button->button, button->modifiers};
        result.clicks = button->down && ImGui::IsMouseDoubleClicked(0) ? 2 : 1;
        return result;
    }
    const auto* focus = std::get_if<FocusChanged>(&event);
    if (focus != nullptr && !focus->focused) { // the release will never come
        return PointerEvent{PointerEvent::Kind::cancel, at, Button::left, held};
    }
    return std::nullopt;
}

void drive(Session& session, const PointerEvent& event, double scale) {
    const Situation situation{session.history.settled(),
                              session.history.live(),
                              session.studies,
                              {session.view.camera, session.canvas},
                              scale};
    Reaction reaction = react(session.gesture, session.view, event, situation);
    session.gesture = std::move(reaction.gesture);
    session.view = std::move(reaction.view);
    if (reaction.edit) {
        session.apply(std::move(*reaction.edit));
    }
}

/// A press with Space held down moves the view.
void markPan(Session& session, PointerEvent& event) {
    auto& held = session.heldKey;
    if (event.kind == PointerEvent::Kind::press && held && held->key == Key::space) {
        event.pans = true;
        held->served = true;
    }
}

Modifiers heldModifiers() {
    const auto& io = ImGui::GetIO();
    return {io.KeyShift, io.KeyCtrl, io.KeyAlt};
}

/// The right button: the menu of what lies under the pointer, which is turned to first. (While a
/// gesture goes on, it restores.)
void openContextMenu(Session& session, double scale) {
    auto& view = session.view;
    const Hit hit = pick(session.document(), session.studies, view, {view.camera, session.canvas},
                         session.pointer, scale);
    session.contextMenu = ContextMenu{Context::canvas, session.pointer};
    if (hit.point) {
        session.contextMenu->context = Context::point;
        if (!view.selection.contains(*hit.point)) {
            view.selection = {*hit.point};
        }
        activate(view, hit.point->curve);
    } else if (hit.curve) {
        session.contextMenu->context = Context::curve;
        activate(view, hit.curve->curve);
        view.cursor = hit.curve->spot;
        view.playing = false;
    }
}

} // namespace

void drawCanvas(Session& session, const Stage& stage, std::span<const InputEvent> events) {
    beginPanel("canvas", stage,
               ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoScrollbar |
                   ImGuiWindowFlags_NoScrollWithMouse);
    ImGui::SetCursorPos({0, 0});
    ImGui::InvisibleButton(
        "surface", {static_cast<float>(stage.rect.width), static_cast<float>(stage.rect.height)},
        ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonMiddle |
            ImGuiButtonFlags_MouseButtonRight);
    const bool over =
        ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem) && !session.dialog;
    ImGui::End();

    session.pointerOnCanvas = over;
    for (const auto& event : events) {
        if (const auto* moved = std::get_if<PointerMoved>(&event)) {
            session.pointer = {moved->x, moved->y};
        }
        const bool busy = !std::holds_alternative<Idle>(session.gesture);
        const auto* wheel = std::get_if<WheelTurned>(&event);
        const auto* button = std::get_if<PointerButton>(&event);
        if (over && !busy && button != nullptr && button->down && button->button == Button::right) {
            openContextMenu(session, stage.scale);
        } else if (wheel != nullptr && over) {
            session.view.camera = zoomed({session.view.camera, session.canvas}, session.pointer,
                                         std::pow(zoomPerNotch, wheel->dy));
        } else if (auto pointer = pointerEvent(event, session.pointer, heldModifiers());
                   pointer && (over || busy)) {
            markPan(session, *pointer);
            drive(session, *pointer, stage.scale);
        }
    }
    if (!over && std::holds_alternative<Idle>(session.gesture)) {
        session.view.hovered.reset();
        session.view.ghost.reset();
        session.view.hoveredGrip.reset();
        session.view.hoversStem = false;
    }
}

} // namespace splineloft::ui
