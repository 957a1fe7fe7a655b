// The hand with nothing in it: what it hovers over, and what a press begins.
#include "ui/canvas/gestures/steps.h"

#include "core/document/edits.h"
#include "core/spline/catalog.h"
#include "ui/canvas/hints.h"

#include <algorithm>
#include <iterator>

namespace splineloft::ui {
namespace {

std::optional<Stem> stemUnder(const View& view, const PointerEvent& event, const Situation& s) {
    return stemAt(stemsOf(s.live, view, s.viewport, s.scale), event.at, s.scale);
}

std::optional<Grip> gripUnder(const View& view, const PointerEvent& event, const Situation& s) {
    const auto gizmo = gizmoOf(s.live, view, s.viewport, s.scale);
    return gizmo ? gripAt(*gizmo, event.at, s.scale) : std::nullopt;
}

Reaction hover(const View& view, const PointerEvent& event, const Situation& s) {
    Reaction reaction = stay(Idle{}, view);
    const Hit hit = pick(s.live, s.studies, view, s.viewport, event.at, s.scale);
    auto& next = reaction.view;
    next.hovered = hit.point;
    next.ghost.reset();
    next.hoversStem = !hit.point && stemUnder(view, event, s);
    next.hoveredGrip = hit.point || next.hoversStem ? std::nullopt : gripUnder(view, event, s);
    const bool free = !next.hoversStem && !next.hoveredGrip && view.tool == Tool::select;
    if (free) {
        next.ghost = hit.curve;
    }
    return reaction;
}

/// Of the points that lie on top of one another at the pointer, the one after `id`.
PointId nextUnder(const PointId& id, const View& view, const PointerEvent& event,
                  const Situation& s) {
    const auto under = pointsUnder(s.live, s.studies, view, s.viewport, event.at, s.scale);
    const auto after = std::ranges::upper_bound(under, id);
    return after != under.end() ? *after : under.empty() ? id : under.front();
}

Reaction pressPoint(const View& view, const PointerEvent& event, const PointId& id) {
    Reaction reaction = stay(Idle{}, view);
    auto& selection = reaction.view.selection;
    if (event.clicks == 2 && id.part == Part::point) {
        selection = {id};
        reaction.view.exactEntry = id;
        return reaction;
    }
    using Click = DraggingPoints::Click;
    const bool wasSelected = selection.contains(id);
    activate(reaction.view, id.curve);
    if (!event.modifiers.shift && !wasSelected) {
        selection.clear();
    }
    selection.insert(id);
    const auto click = !wasSelected            ? Click::selects
                       : event.modifiers.shift ? Click::deselects
                                               : Click::selectsOnly;
    reaction.gesture = DraggingPoints{selection.ids(), id, event.at, false, click};
    return reaction;
}

Reaction pressStem(const View& view, const PointerEvent& event, Stem stem, const Situation& s) {
    if (event.clicks < 2) {
        return stay(SlidingStem{std::move(stem), event.at}, view);
    }
    Reaction reaction = stay(Idle{}, view);
    const auto& [curve, index, part] = stem.point;
    reaction.edit =
        Edit{withValueAt(s.settled, curve, stem.value, index, stem.value.parameter.neutral),
             Phase::commit, settingOf(stem.value, index)};
    return reaction;
}

Reaction pressGrip(const View& view, const PointerEvent& event, const Grip& grip,
                   const Situation& s) {
    Transforming pulling;
    pulling.box = *boxOfSelection(s.live, view);
    pulling.grip = grip;
    pulling.from = event.at;
    std::ranges::copy_if(view.selection, std::back_inserter(pulling.ids),
                         [](const PointId& id) { return id.part == Part::point; });
    return stay(std::move(pulling), view);
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
    if (event.button == Button::middle || (event.pans && event.button == Button::left)) {
        return stay(Panning{event.at, event.button}, view);
    }
    if (event.button != Button::left) {
        return stay(Idle{}, view);
    }
    if (view.tool != Tool::select) {
        return pressWithPen(view, event, s);
    }
    const Hit hit = pick(s.live, s.studies, view, s.viewport, event.at, s.scale);
    if (hit.point) {
        const bool next = event.modifiers.alt && view.selection.contains(*hit.point);
        return pressPoint(view, event, next ? nextUnder(*hit.point, view, event, s) : *hit.point);
    }
    if (auto stem = stemUnder(view, event, s)) {
        return pressStem(view, event, std::move(*stem), s);
    }
    if (const auto grip = gripUnder(view, event, s)) {
        return pressGrip(view, event, *grip, s);
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
