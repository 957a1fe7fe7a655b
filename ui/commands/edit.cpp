// The Edit menu, and the keys that nudge.
#include "ui/commands/menus.h"

#include "core/document/edits.h"
#include "ui/canvas/grid.h"
#include "ui/canvas/hints.h"
#include "ui/canvas/viewport.h"

#include <algorithm>

namespace splineloft::ui {
namespace {

void deleteSelection(Session& session) {
    const auto ids = selected(session);
    const auto label = "Delete " + nameOf(session.document(), ids);
    session.view.selection.clear(); // the points that move up were not selected
    session.apply({deletePoints(session.history.settled(), ids), Phase::commit, label});
}

void insertAtCursor(Session& session) {
    const auto curve = session.view.activeCurve;
    auto inserted = insertOnCurve(session.history.settled(), curve, session.view.cursor);
    const auto label = "Insert " + nameOf(inserted.document, {inserted.point});
    session.apply({std::move(inserted.document), Phase::commit, label});
    session.view.selection = {inserted.point};
}

void selectAll(Session& session) {
    session.view.selection.clear();
    const auto count = session.active()->curve().points.size();
    for (std::size_t i = 0; i < count; ++i) {
        session.view.selection.insert({session.view.activeCurve, i, Part::point});
    }
}

bool hasPoints(const Session& session) {
    return canEditCurve(session) && !session.active()->curve().points.empty();
}

/// Selects the control point that comes so many after the one selected, around the active curve.
void selectAfter(Session& session, int steps) {
    const auto curve = session.view.activeCurve;
    const auto count = static_cast<int>(session.active()->curve().points.size());
    auto& selection = session.view.selection;
    const auto last = std::ranges::find_if(selection, [curve](const PointId& id) {
        return id.curve == curve && id.part == Part::point;
    });
    const int from = last != selection.end() ? static_cast<int>(last->index) : steps > 0 ? -1 : 0;
    const int index = (from + steps + count) % count;
    selection = {{curve, static_cast<std::size_t>(index), Part::point}};
}

/// Esc: whatever is under way ends, else the tool, else the show, else the selection.
void stepBack(Session& session) {
    if (!std::holds_alternative<Idle>(session.gesture)) {
        session.giveUpGesture();
    } else if (session.view.tool != Tool::select) {
        session.view.tool = Tool::select;
    } else if (session.view.presenting) {
        session.present(false);
    } else {
        session.view.selection.clear();
    }
}

/// Moves the selection by so many tenths of a fine grid step.
void nudge(Session& session, double right, double up, double tenths) {
    const double step = tenths * fineGridStep(session.view.camera, session.scale) / 10;
    const auto ids = selected(session);
    session.apply(
        {movedInPlane(session.history.settled(), ids, session.view.axes, right * step, up * step),
         Phase::commit, "Nudge " + nameOf(session.document(), ids)});
}

/// While it plays, arrows step the traveller.
bool canNudge(const Session& session) {
    return hasSelection(session) && !session.view.playing;
}

void addNudges(std::vector<Command>& all) {
    struct Way {
        const char* name;
        Key key;
        double right, up;
    };
    for (const auto& way : {Way{"left", Key::left, -1, 0}, Way{"right", Key::right, 1, 0},
                            Way{"up", Key::up, 0, 1}, Way{"down", Key::down, 0, -1}}) {
        const std::string name = way.name;
        all.push_back({"edit.nudge." + name,
                       "",
                       called("Nudge " + name),
                       {{way.key}},
                       [way](Session& s) { nudge(s, way.right, way.up, 1); },
                       canNudge});
        all.back().repeats = true;
        all.push_back({"edit.nudgeFar." + name,
                       "",
                       called("Nudge " + name + " ten times as far"),
                       {{way.key, shiftKey}},
                       [way](Session& s) { nudge(s, way.right, way.up, 10); },
                       canNudge});
        all.back().repeats = true;
    }
}

} // namespace

void addEditCommands(std::vector<Command>& all) {
    all.push_back({"edit.undo",
                   "Edit",
                   [](const Session& s) { return "Undo " + std::string(s.history.undoLabel()); },
                   {{Key::z, controlKey}},
                   [](Session& s) { s.undo(); },
                   [](const Session& s) { return s.history.canUndo() || s.history.previewing(); }});
    all.back().repeats = true;
    all.back().contexts = {Context::canvas};
    all.push_back({"edit.redo",
                   "Edit",
                   [](const Session& s) { return "Redo " + std::string(s.history.redoLabel()); },
                   {{Key::y, controlKey}, {Key::z, controlShiftKeys}},
                   [](Session& s) { s.redo(); },
                   [](const Session& s) { return s.history.canRedo(); }});
    all.back().repeats = true;
    all.back().contexts = {Context::canvas};
    addClipboardCommands(all);
    all.push_back({"edit.delete",
                   "Edit",
                   called("Delete points"),
                   {{Key::del}, {Key::backspace}},
                   deleteSelection,
                   hasSelection});
    all.back().startsGroup = true;
    all.back().contexts = {Context::point};
    all.push_back({"edit.insert",
                   "Edit",
                   called("Insert a point at u"),
                   {{Key::i}},
                   insertAtCursor,
                   [](const Session& s) { return hasPieces(s) && canEditCurve(s); }});
    all.back().contexts = {Context::curve};
    all.push_back({"edit.selectAll",
                   "Edit",
                   called("Select all points of the curve"),
                   {{Key::a, controlKey}},
                   selectAll,
                   canEditCurve});
    all.back().contexts = {Context::point, Context::curve};
    all.push_back({"edit.selectNext",
                   "Edit",
                   called("Select the next point"),
                   {{Key::tab}},
                   [](Session& s) { selectAfter(s, 1); },
                   hasPoints});
    all.back().repeats = true;
    all.push_back({"edit.selectPrevious",
                   "Edit",
                   called("Select the previous point"),
                   {{Key::tab, shiftKey}},
                   [](Session& s) { selectAfter(s, -1); },
                   hasPoints});
    all.back().repeats = true;
    all.push_back({"edit.exact",
                   "Edit",
                   called("Type in the numbers of the point"),
                   {{Key::enter}},
                   [](Session& s) { s.view.exactEntry = *s.view.selection.begin(); },
                   [](const Session& s) {
                       return handsOff(s) && s.view.tool == Tool::select &&
                              s.view.selection.size() == 1;
                   }});
    all.back().contexts = {Context::point};
    all.push_back({"edit.escape",
                   "Edit",
                   called("Cancel, or clear the selection"),
                   {{Key::escape}},
                   stepBack});
    addNudges(all);
}

} // namespace splineloft::ui
