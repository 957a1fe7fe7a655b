#include "ui/canvas/gesture.h"

#include "core/document/edits.h"
#include "core/spline/catalog.h"
#include "core/spline/measure/nearest.h"
#include "ui/canvas/hints.h"
#include "ui/canvas/snap.h"

#include <algorithm>
#include <cmath>

namespace splineloft::ui {
namespace {

// A hand trembles: below this a press and release is a click. Design pixels.
constexpr double clickSlack = 3;

using Kind = PointerEvent::Kind;

Reaction stay(const Gesture& gesture, const View& view) {
    return {gesture, view};
}

bool beyondClick(ScreenPoint a, ScreenPoint b, const Situation& situation) {
    return std::hypot(a.x - b.x, a.y - b.y) > clickSlack * situation.scale;
}

std::vector<PointId> listed(const std::set<PointId>& ids) {
    return {ids.begin(), ids.end()};
}

/// A new curve of the family in use, with its first point.
Document withNewCurve(const Document& document, const View& view, PlanePoint at) {
    Curve curve;
    curve.name = "curve " + std::to_string(document.curves.size() + 1);
    if (view.activeCurve < document.curves.size()) {
        const Curve& model = *document.curves[view.activeCurve];
        curve.family = model.family;
        curve.parameters = model.parameters;
        curve.ends = model.ends;
    }
    completeParameters(curve);
    curve.points.append(Point{at.x, at.y});
    if (familyOf(curve).usesTangents) {
        curve.tangents.append(Point{0, 0});
    }
    return addCurve(document, std::move(curve));
}

/// Turns to a curve; u goes to its start, for it may have fewer pieces than the one before.
void activate(View& view, std::size_t curve) {
    if (curve != view.activeCurve) {
        view.cursor = {};
    }
    view.activeCurve = curve;
}

// --- idle

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

Reaction pressWithPen(const View& view, const PointerEvent& event, const Situation& s) {
    const PlanePoint at = tidied(s.viewport.toPlane(event.at), s.viewport.camera);
    Reaction reaction = stay(Idle{}, view);
    const bool going = view.tool == Tool::pen && view.activeCurve < s.settled.curves.size() &&
                       !s.settled.curves[view.activeCurve]->closed;
    const auto under = pick(s.live, s.studies, view, s.viewport, event.at, s.scale).point;
    if (going && under == PointId{view.activeCurve, 0, Part::point} &&
        familyOf(*s.settled.curves[view.activeCurve]).closable &&
        s.settled.curves[view.activeCurve]->points.size() > 2) {
        reaction.edit = Edit{setClosed(s.settled, view.activeCurve, true), Phase::commit, "Close"};
        reaction.view.tool = Tool::select;
        return reaction;
    }
    Inserted added;
    if (going) {
        const Curve& curve = *s.settled.curves[view.activeCurve];
        added = appendPoint(s.settled, view.activeCurve,
                            lifted(curve, view.axes, Point(curve.points.dimension()), at));
    } else {
        added = {withNewCurve(s.settled, view, at), {s.settled.curves.size(), 0, Part::point}};
    }
    reaction.view.activeCurve = added.point.curve;
    reaction.view.selection = {added.point};
    reaction.view.tool = Tool::pen;
    reaction.edit = Edit{added.document, Phase::preview, ""};
    reaction.gesture = PlacingPoint{added.point, std::move(added.document), event.at};
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

Reaction step(const Idle& idle, const View& view, const PointerEvent& event, const Situation& s) {
    switch (event.kind) {
    case Kind::move: return hover(view, event, s);
    case Kind::press: return press(view, event, s);
    default: return stay(idle, view);
    }
}

// --- dragging control points

/// The whole displacement of a drag, from where it began: nothing adds up.
SnappedMove moveOf(const DraggingPoints& drag, const View& view, const PointerEvent& event,
                   const Situation& s) {
    SnappedMove move{(event.at.x - drag.from.x) / s.viewport.camera.pixelsPerUnit,
                     -(event.at.y - drag.from.y) / s.viewport.camera.pixelsPerUnit, std::nullopt};
    if (event.modifiers.shift) {
        (std::abs(move.dx) >= std::abs(move.dy) ? move.dy : move.dx) = 0;
    }
    return event.modifiers.control ? snapped(move, drag.ids, drag.grabbed, view, s)
                                   : tidied(move, drag.grabbed, view, s);
}

Document dragged(const DraggingPoints& drag, const SnappedMove& move, const View& view,
                 const Situation& s) {
    // A tangent is drawn at a third of its length, so its tip moves three times as far.
    const double stretch = drag.grabbed.part == Part::tangent ? 3 : 1;
    const auto ids = drag.grabbed.part == Part::tangent ? std::vector{drag.grabbed} : drag.ids;
    return movedInPlane(s.settled, ids, view.axes, stretch * move.dx, stretch * move.dy);
}

Reaction step(const DraggingPoints& drag, const View& view, const PointerEvent& event,
              const Situation& s) {
    const bool cancels =
        event.kind == Kind::cancel || (event.kind == Kind::press && event.button == Button::right);
    if (cancels) {
        return {Idle{}, view, Edit{s.settled, Phase::cancel, ""}};
    }
    if (event.kind == Kind::release && event.button == Button::left) {
        Reaction reaction = stay(Idle{}, view);
        if (drag.moved) {
            const auto move = moveOf(drag, view, event, s);
            reaction.edit = Edit{dragged(drag, move, view, s), Phase::commit,
                                 "Move " + nameOf(s.settled, drag.ids)};
        } else if (drag.selectOnlyThis) {
            reaction.view.selection = {drag.grabbed};
        }
        return reaction;
    }
    DraggingPoints next = drag;
    next.moved = drag.moved || beyondClick(drag.from, event.at, s);
    if (event.kind != Kind::move || !next.moved) {
        return stay(next, view);
    }
    const auto move = moveOf(drag, view, event, s);
    next.snappedTo = move.to;
    return {next, view, Edit{dragged(drag, move, view, s), Phase::preview, ""}};
}

// --- the other gestures

Reaction step(const Boxing& box, const View& view, const PointerEvent& event, const Situation& s) {
    const bool cancels =
        event.kind == Kind::cancel || (event.kind == Kind::press && event.button == Button::right);
    if (cancels) {
        Reaction reaction = stay(Idle{}, view);
        reaction.view.selection = box.kept;
        return reaction;
    }
    Boxing next = box;
    next.now = event.at;
    Reaction reaction = stay(next, view);
    reaction.view.selection = box.kept;
    if (beyondClick(box.from, event.at, s)) {
        reaction.view.selection.merge(
            pointsInside(s.live, view, s.viewport, spanned(box.from, event.at)));
    }
    if (event.kind == Kind::release && event.button == Button::left) {
        reaction.gesture = Idle{};
        if (!reaction.view.selection.empty()) {
            activate(reaction.view, reaction.view.selection.begin()->curve);
        }
    }
    return reaction;
}

Reaction step(const Panning& pan, const View& view, const PointerEvent& event, const Situation&) {
    if (event.kind == Kind::cancel ||
        (event.kind == Kind::release && event.button == Button::middle)) {
        return stay(Idle{}, view);
    }
    Reaction reaction = stay(Panning{event.at}, view);
    reaction.view.camera = panned(view.camera, event.at.x - pan.last.x, event.at.y - pan.last.y);
    return reaction;
}

Reaction step(const SlidingCursor& sliding, const View& view, const PointerEvent& event,
              const Situation& s) {
    if (event.kind == Kind::cancel ||
        (event.kind == Kind::release && event.button == Button::left)) {
        return stay(Idle{}, view);
    }
    Reaction reaction = stay(sliding, view);
    const PlanePoint at = s.viewport.toPlane(event.at);
    const auto nearest = nearestTo(s.studies[view.activeCurve].plane(view.axes), Point{at.x, at.y});
    if (nearest) {
        reaction.view.cursor = nearest->spot;
    }
    return reaction;
}

/// The document with the handles of a point just placed pulled toward the pointer.
Document pulled(const PlacingPoint& placing, const View& view, PlanePoint at) {
    const Curve& curve = *placing.placed.curves[placing.point.curve];
    const Point anchor = curve.points.at(placing.point.index);
    const Point pointer = lifted(curve, view.axes, anchor, at);
    if (familyOf(curve).usesTangents) {
        return setPoint(placing.placed, {placing.point.curve, placing.point.index, Part::tangent},
                        3.0 * (pointer - anchor));
    }
    if (familyOf(curve).hasHandles && placing.point.index > 0) {
        return setPoint(placing.placed, {placing.point.curve, placing.point.index - 1, Part::point},
                        2.0 * anchor - pointer);
    }
    return placing.placed;
}

Reaction step(const PlacingPoint& placing, const View& view, const PointerEvent& event,
              const Situation& s) {
    const bool cancels =
        event.kind == Kind::cancel || (event.kind == Kind::press && event.button == Button::right);
    if (cancels) {
        return {Idle{}, view, Edit{s.settled, Phase::cancel, ""}};
    }
    Document next = beyondClick(placing.from, event.at, s)
                        ? pulled(placing, view, s.viewport.toPlane(event.at))
                        : placing.placed;
    if (event.kind == Kind::release && event.button == Button::left) {
        const auto label = "Add " + nameOf(next, {placing.point});
        return {Idle{}, view, Edit{std::move(next), Phase::commit, label}};
    }
    return {placing, view, Edit{std::move(next), Phase::preview, ""}};
}

} // namespace

Reaction react(const Gesture& gesture, const View& view, const PointerEvent& event,
               const Situation& situation) {
    return std::visit([&](const auto& state) { return step(state, view, event, situation); },
                      gesture);
}

ScreenRect spanned(ScreenPoint a, ScreenPoint b) {
    return {std::min(a.x, b.x), std::min(a.y, b.y), std::abs(a.x - b.x), std::abs(a.y - b.y)};
}

} // namespace splineloft::ui
