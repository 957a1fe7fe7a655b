#include "ui/canvas/hints.h"

#include "core/document/edits.h"
#include "core/document/handles.h"
#include "ui/canvas/wording.h"

namespace splineloft::ui {

std::string nameOf(const Document& document, const std::vector<PointId>& ids) {
    if (ids.size() != 1) {
        return std::to_string(ids.size()) + " points";
    }
    const auto& id = ids.front();
    const auto name = plainPointName(id.index);
    if (id.part == Part::tangent) {
        return "the tangent at " + name;
    }
    return anchorOf(*document.curves[id.curve], id.index) ? "handle " + name : name;
}

/// What a click of the pen would do.
static std::string penHint(const View& view, const Document& document) {
    const bool going = view.tool == Tool::pen && view.activeCurve < document.curves.size() &&
                       !document.curves[view.activeCurve]->closed &&
                       document.curves[view.activeCurve].look.isTouchable();
    if (!going) {
        return document.curves.empty() ? "Click to begin a curve · Enter or Esc ends"
                                       : "Click to begin another curve · Enter or Esc ends";
    }
    const Curve& curve = *document.curves[view.activeCurve];
    const bool closes = familyOf(curve).closable && curve.points.size() > 2;
    return std::string("Click to add a point at the end · ") +
           (closes ? "click the first point to close · " : "") +
           "Shift keeps to 45° · Ctrl snaps · Enter or Esc ends";
}

std::string hintFor(const Gesture& gesture, const View& view, const Document& document) {
    if (std::holds_alternative<DraggingPoints>(gesture)) {
        return "Shift keeps the axis or 45° · Ctrl snaps to grid and points · Esc or right click "
               "restores";
    }
    if (const auto* pulling = std::get_if<Transforming>(&gesture)) {
        return pulling->grip.turns() ? "Shift turns by 45° · Ctrl by 15° · Esc restores"
                                     : "Shift scales evenly · Alt about the middle · Ctrl snaps to "
                                       "the grid · Esc restores";
    }
    if (std::holds_alternative<SlidingStem>(gesture)) {
        return "Drag along the stem · Esc restores";
    }
    if (std::holds_alternative<Boxing>(gesture)) {
        return "Release to select the points inside · Esc leaves the selection as it was";
    }
    if (std::holds_alternative<Panning>(gesture)) {
        return "Drag to move the view";
    }
    if (std::holds_alternative<SlidingCursor>(gesture)) {
        return "Drag along the curve to slide u";
    }
    if (const auto* placing = std::get_if<PlacingPoint>(&gesture)) {
        const auto& family = familyOf(*placing->placed.curves[placing->point.curve]);
        return std::string(family.hasHandles     ? "Drag to pull out handles · "
                           : family.usesTangents ? "Drag to pull out the tangent · "
                                                 : "") +
               "release to place the point";
    }
    if (view.tool != Tool::select) {
        return penHint(view, document);
    }
    if (view.hovered) {
        return "Drag to move " + nameOf(document, {*view.hovered}) +
               " · double-click for exact numbers · Shift+click selects more · Alt+click: the one "
               "below";
    }
    if (view.hoveredGrip) {
        return view.hoveredGrip->turns() ? "Drag to turn the selection"
                                         : "Drag to scale the selection";
    }
    if (view.hoversStem) {
        return "Drag to change the value at this point · double-click for the neutral value";
    }
    if (view.ghost && view.ghost->curve < document.curves.size()) {
        const bool keeps = insertionKeepsShape(*document.curves[view.ghost->curve]);
        return std::string(view.ghost->curve == view.activeCurve ? "Drag to slide u"
                                                                 : "Click to work on this curve") +
               " · double-click to insert a point here" +
               (keeps ? ": the curve keeps its shape" : "");
    }
    return document.curves.empty()
               ? "Press P and click to lay down points, or open a file with Ctrl+O"
               : "Drag to select · middle-drag moves the view · wheel zooms · P adds points";
}

} // namespace splineloft::ui
