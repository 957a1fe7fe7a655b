// The pen: points added at the end, with their handles pulled out.
#include "ui/canvas/gestures/steps.h"

#include "core/document/edits.h"
#include "core/document/handles.h"
#include "core/spline/catalog.h"
#include "ui/canvas/hints.h"
#include "ui/canvas/snap.h"

namespace splineloft::ui {
namespace {

/// A new curve of the family in use, with its first point.
Document withNewCurve(const Document& document, const View& view, PlanePoint at) {
    Curve curve;
    curve.name = "curve " + std::to_string(document.curves.size() + 1);
    if (document.curves.empty()) {
        curve.family = view.firstFamily;
        curve.ends = familyOf(curve).ends.front();
    }
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

/// A pointer seen from a place, as the keys held bend its way.
SnappedMove toward(const PointerEvent& event, PlanePoint from, const std::vector<PointId>& ids,
                   const View& view, const Situation& s) {
    const PlanePoint at = s.viewport.toPlane(event.at);
    return steered(at.x - from.x, at.y - from.y, from, event.modifiers, ids, view, s);
}

/// The document with the handles of a point just placed pulled to a place.
Document pulled(const PlacingPoint& placing, const View& view, PlanePoint at) {
    const Curve& curve = *placing.placed.curves[placing.point.curve];
    const Point anchor = curve.points.at(placing.point.index);
    const Point pointer = lifted(curve, view.axes, anchor, at);
    if (familyOf(curve).usesTangents) {
        return setPoint(placing.placed, {placing.point.curve, placing.point.index, Part::tangent},
                        3.0 * (pointer - anchor));
    }
    if (familyOf(curve).hasHandles && placing.point.index == 0) {
        return startHandle(placing.placed, placing.point.curve, pointer);
    }
    if (familyOf(curve).hasHandles) {
        return setPoint(placing.placed, {placing.point.curve, placing.point.index - 1, Part::point},
                        2.0 * anchor - pointer);
    }
    return placing.placed;
}

} // namespace

Reaction pressWithPen(const View& view, const PointerEvent& event, const Situation& s) {
    Reaction reaction = stay(Idle{}, view);
    const bool going = view.tool == Tool::pen && view.activeCurve < s.settled.curves.size() &&
                       !s.settled.curves[view.activeCurve]->closed &&
                       s.settled.curves[view.activeCurve].look.isTouchable();
    const auto under = pick(s.live, s.studies, view, s.viewport, event.at, s.scale).point;
    if (going && under == PointId{view.activeCurve, 0, Part::point} &&
        familyOf(*s.settled.curves[view.activeCurve]).closable &&
        s.settled.curves[view.activeCurve]->points.size() > 2) {
        reaction.edit = Edit{setClosed(s.settled, view.activeCurve, true), Phase::commit, "Close"};
        reaction.view.tool = Tool::select;
        return reaction;
    }
    const auto points = going ? s.settled.curves[view.activeCurve]->points.size() : 0;
    const auto last = points == 0 ? 0
                      : hasHandles(*s.settled.curves[view.activeCurve])
                          ? lastAnchor(*s.settled.curves[view.activeCurve])
                          : points - 1;
    const PlanePoint from =
        points > 0 ? PointPlaces(s.settled, view.axes)[{view.activeCurve, last, Part::point}]
                   : tidied(s.viewport.toPlane(event.at), s.viewport.camera);
    const auto move = toward(event, from, {}, view, s);
    const PlanePoint at = move.from(from);
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
    reaction.gesture =
        PlacingPoint{added.point, std::move(added.document), event.at, {move.course, at, move.to}};
    return reaction;
}

Reaction step(const PlacingPoint& placing, const View& view, const PointerEvent& event,
              const Situation& s) {
    if (givesUp(event)) {
        return {Idle{}, view, Edit{s.settled, Phase::cancel, ""}};
    }
    PlacingPoint going = placing;
    Document next = placing.placed;
    if (beyondClick(placing.from, event.at, s)) {
        const PlanePoint anchor = PointPlaces(placing.placed, view.axes)[placing.point];
        const auto move = toward(event, anchor, {placing.point}, view, s);
        const PlanePoint at = move.from(anchor);
        next = pulled(placing, view, at);
        going.held = {move.course, at, move.to};
    }
    if (letsGo(event)) {
        const auto label = "Add " + nameOf(next, {placing.point});
        return {Idle{}, view, Edit{std::move(next), Phase::commit, label}};
    }
    return {going, view, Edit{std::move(next), Phase::preview, ""}};
}

} // namespace splineloft::ui
