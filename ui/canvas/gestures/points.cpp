// Dragging control points.
#include "ui/canvas/gestures/steps.h"

#include "core/document/edits.h"
#include "ui/canvas/hints.h"
#include "ui/canvas/snap.h"

#include <cmath>

namespace splineloft::ui {
namespace {

PlanePoint startOf(const DraggingPoints& drag, const View& view, const Situation& s) {
    return PointPlaces(s.settled, view.axes)[drag.grabbed];
}

/// The whole displacement of a drag, from where it began: nothing adds up.
SnappedMove moveOf(const DraggingPoints& drag, const View& view, const PointerEvent& event,
                   const Situation& s) {
    const double dx = s.viewport.toPlane(event.at.x - drag.from.x);
    const double dy = -s.viewport.toPlane(event.at.y - drag.from.y);
    return steered(dx, dy, startOf(drag, view, s), event.modifiers, drag.ids, view, s);
}

Document dragged(const DraggingPoints& drag, const SnappedMove& move, const View& view,
                 const Situation& s) {
    // A tangent is drawn at a third of its length, so its tip moves three times as far.
    const double stretch = drag.grabbed.part == Part::tangent ? 3 : 1;
    const auto ids = drag.grabbed.part == Part::tangent ? std::vector{drag.grabbed} : drag.ids;
    return movedInPlane(s.settled, ids, view.axes, stretch * move.dx, stretch * move.dy);
}

} // namespace

Reaction step(const DraggingPoints& drag, const View& view, const PointerEvent& event,
              const Situation& s) {
    if (givesUp(event)) {
        return {Idle{}, view, Edit{s.settled, Phase::cancel, ""}};
    }
    if (letsGo(event)) {
        Reaction reaction = stay(Idle{}, view);
        if (drag.moved) {
            const auto move = moveOf(drag, view, event, s);
            reaction.edit = Edit{dragged(drag, move, view, s), Phase::commit,
                                 "Move " + nameOf(s.settled, drag.ids)};
        } else if (drag.click == DraggingPoints::Click::selectsOnly) {
            reaction.view.selection = {drag.grabbed};
        } else if (drag.click == DraggingPoints::Click::deselects) {
            reaction.view.selection.erase(drag.grabbed);
        }
        return reaction;
    }
    DraggingPoints next = drag;
    next.moved = drag.moved || beyondClick(drag.from, event.at, s);
    if (event.kind != Kind::move || !next.moved) {
        return stay(next, view);
    }
    const auto move = moveOf(drag, view, event, s);
    next.held = {move.course, move.from(startOf(drag, view, s)), move.to};
    return {next, view, Edit{dragged(drag, move, view, s), Phase::preview, ""}};
}

} // namespace splineloft::ui
