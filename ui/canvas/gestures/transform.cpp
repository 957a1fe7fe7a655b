// Pulling on the frame of a selection, and sliding a number at its point.
#include "ui/canvas/gestures/steps.h"

#include "core/document/edits.h"
#include "ui/canvas/grid.h"
#include "ui/canvas/hints.h"

namespace splineloft::ui {
namespace {

Transform transformBy(const Transforming& pulling, const PointerEvent& event, const Situation& s) {
    const bool control = event.modifiers.control;
    return transformOf(pulling.box, {.grip = pulling.grip,
                                     .from = s.viewport.toPlane(pulling.from),
                                     .to = s.viewport.toPlane(event.at),
                                     .evenly = event.modifiers.shift,
                                     .aboutMiddle = event.modifiers.alt,
                                     .snap = control ? fineGridStep(s.viewport.camera, s.scale) : 0,
                                     .byFifteen = control});
}

Document transformed(const Transforming& pulling, const PlaneMap& map, const View& view,
                     const Situation& s) {
    return transformPoints(s.settled, pulling.ids, map, view.axes.across, view.axes.up);
}

} // namespace

Reaction step(const Transforming& pulling, const View& view, const PointerEvent& event,
              const Situation& s) {
    if (givesUp(event)) {
        return {Idle{}, view, Edit{s.settled, Phase::cancel, ""}};
    }
    Transforming next = pulling;
    next.moved = pulling.moved || beyondClick(pulling.from, event.at, s);
    const Transform done = transformBy(pulling, event, s);
    if (letsGo(event)) {
        Reaction reaction = stay(Idle{}, view);
        if (pulling.moved) {
            const auto deed = std::string(pulling.grip.turns() ? "Turn " : "Scale ");
            reaction.edit = Edit{transformed(pulling, done.map, view, s), Phase::commit,
                                 deed + nameOf(s.settled, pulling.ids)};
        }
        return reaction;
    }
    if (event.kind != Kind::move || !next.moved) {
        return stay(next, view);
    }
    next.now = event.at;
    next.done = done;
    return {next, view, Edit{transformed(pulling, done.map, view, s), Phase::preview, ""}};
}

Reaction step(const SlidingStem& sliding, const View& view, const PointerEvent& event,
              const Situation& s) {
    if (givesUp(event)) {
        return {Idle{}, view, Edit{s.settled, Phase::cancel, ""}};
    }
    const auto& stem = sliding.stem;
    const auto changed = [&](double number) {
        return withValueAt(s.settled, stem.point.curve, stem.value, stem.point.index, number);
    };
    if (letsGo(event)) {
        Reaction reaction = stay(Idle{}, view);
        if (sliding.moved) {
            reaction.edit = Edit{changed(stem.numberAt(event.at)), Phase::commit,
                                 settingOf(stem.value, stem.point.index)};
        }
        return reaction;
    }
    SlidingStem next = sliding;
    next.moved = sliding.moved || beyondClick(sliding.from, event.at, s);
    if (event.kind != Kind::move || !next.moved) {
        return stay(next, view);
    }
    return {next, view, Edit{changed(stem.numberAt(event.at)), Phase::preview, ""}};
}

} // namespace splineloft::ui
