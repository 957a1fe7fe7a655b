// The hand with nothing in it: what it hovers over, and what a press begins.
#include "ui/canvas/gestures/steps.h"

#include "core/document/edits.h"
#include "core/spline/catalog.h"
#include "ui/canvas/hints.h"

namespace splineloft::ui {
namespace {

std::vector<PointId> listed(const std::set<PointId>& ids) {
    return {ids.begin(), ids.end()};
}

Reaction hover(const View& view, const PointerEvent& event, const Situation& s) {
    Reaction reaction = stay(Idle{}, view);
    const Hit hit = pick(s.live, s.studies, view, s.viewport, event.at, s.scale);
    reaction.view.hovered = hit.point;
    reaction.view.ghost.reset();
    if (hit.curve && hit.curve->curve == view.activeCurve && view.tool == Tool::select) {
        reaction.view.ghost = hit.curve->spot;
    }
    return reaction;
}

Reaction pressPoint(const View& view, const PointerEvent& event, const PointId& id) {
    Reaction reaction = stay(Idle{}, view);
    auto& selection = reaction.view.selection;
    const bool wasSelected = selection.contains(id);
    activate(reaction.view, id.curve);
    if (event.modifiers.shift && wasSelected) {
        selection.erase(id);
        return reaction;
    }
    if (!event.modifiers.shift && !wasSelected) {
        selection.clear();
    }
    selection.insert(id);
    reaction.gesture = DraggingPoints{listed(selection), id, event.at, false,
                                      wasSelected && !event.modifiers.shift};
    return reaction;
}

Reaction pressCurve(const View& view, const PointerEvent& event, const CurveHit& hit,
                    const Situation& s) {
    Reaction reaction = stay(SlidingCursor{}, view);
    if (event.clicks == 2 || event.modifiers.control) {
        auto inserted = insertOnCurve(s.settled, hit.curve, hit.spot);
        reaction.gesture = Idle{};
        reaction.view.activeCurve = hit.curve;
        reaction.view.selection = {inserted.point};
        reaction.view.ghost.reset();
        const auto name = nameOf(inserted.document, {inserted.point});
        reaction.edit = Edit{std::move(inserted.document), Phase::commit, "Insert " + name};
        return reaction;
    }
    if (hit.curve != view.activeCurve) {
        reaction.view.selection.clear();
    }
    reaction.view.activeCurve = hit.curve;
    reaction.view.cursor = hit.spot;
    reaction.view.playing = false;
    return reaction;
}

Reaction press(const View& view, const PointerEvent& event, const Situation& s) {
    if (event.button == Button::middle) {
        return stay(Panning{event.at}, view);
    }
    if (event.button != Button::left) {
        return stay(Idle{}, view);
    }
    if (view.tool != Tool::select) {
        return pressWithPen(view, event, s);
    }
    const Hit hit = pick(s.live, s.studies, view, s.viewport, event.at, s.scale);
    if (hit.point) {
        return pressPoint(view, event, *hit.point);
    }
    if (hit.curve) {
        return pressCurve(view, event, *hit.curve, s);
    }
    Reaction reaction = stay(Idle{}, view);
    if (!event.modifiers.shift) {
        reaction.view.selection.clear();
    }
    reaction.gesture = Boxing{event.at, event.at, reaction.view.selection};
    return reaction;
}

} // namespace

Reaction step(const Idle& idle, const View& view, const PointerEvent& event, const Situation& s) {
    switch (event.kind) {
    case Kind::move: return hover(view, event, s);
    case Kind::press: return press(view, event, s);
    default: return stay(idle, view);
    }
}

} // namespace splineloft::ui
