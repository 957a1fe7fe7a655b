// Gestures that change nothing of the document: selecting in a box, moving the view, sliding u.
#include "ui/canvas/gestures/steps.h"

#include "core/spline/measure/nearest.h"

namespace splineloft::ui {

Reaction step(const Boxing& box, const View& view, const PointerEvent& event, const Situation& s) {
    if (givesUp(event)) {
        Reaction reaction = stay(Idle{}, view);
        reaction.view.selection = box.kept;
        return reaction;
    }
    Boxing next = box;
    next.now = event.at;
    Reaction reaction = stay(next, view);
    reaction.view.selection = box.kept;
    if (beyondClick(box.from, event.at, s)) {
        reaction.view.selection.insert(
            pointsInside(s.live, s.studies, view, s.viewport, spanned(box.from, event.at)));
    }
    if (letsGo(event)) {
        reaction.gesture = Idle{};
        if (!reaction.view.selection.empty()) {
            activate(reaction.view, reaction.view.selection.begin()->curve);
        }
    }
    return reaction;
}

Reaction step(const Panning& pan, const View& view, const PointerEvent& event, const Situation&) {
    if (event.kind == Kind::cancel || (event.kind == Kind::release && event.button == pan.button)) {
        return stay(Idle{}, view);
    }
    Reaction reaction = stay(Panning{event.at, pan.button}, view);
    reaction.view.camera = panned(view.camera, event.at.x - pan.last.x, event.at.y - pan.last.y);
    return reaction;
}

Reaction step(const SlidingCursor& sliding, const View& view, const PointerEvent& event,
              const Situation& s) {
    if (event.kind == Kind::cancel || letsGo(event)) {
        return stay(Idle{}, view);
    }
    Reaction reaction = stay(sliding, view);
    const PlanePoint at = s.viewport.toPlane(event.at);
    const auto nearest = nearestTo(s.studies[view.activeCurve].inPlane(view.axes), at);
    if (nearest) {
        reaction.view.cursor = nearest->spot;
    }
    return reaction;
}

} // namespace splineloft::ui
