// Commands for the selected points, and for what the clipboard holds.
#include "ui/commands/menus.h"

#include "core/document/curve_edits.h"
#include "core/document/edits.h"
#include "core/document/handle_modes.h"
#include "core/formats/clipboard.h"
#include "ui/canvas/hints.h"
#include "ui/canvas/viewport.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <numeric>

namespace splineloft::ui {
namespace {

// A copy lies at least so far to the right of and below what it was made from, design pixels, by a
// step of a grid.
constexpr double copyOffset = 24;

// Without an interface there is no clipboard: the commands still run, on an empty one.
std::string clipboardText() {
    const char* text = ImGui::GetCurrentContext() != nullptr ? ImGui::GetClipboardText() : nullptr;
    return text != nullptr ? text : "";
}
void setClipboardText(const std::string& text) {
    if (ImGui::GetCurrentContext() != nullptr) {
        ImGui::SetClipboardText(text.c_str());
    }
}

bool selectionHasHandles(const Session& session) {
    return hasSelection(session) &&
           std::ranges::any_of(session.view.selection, [&](const PointId& id) {
               return familyOf(*session.document().curves[id.curve]).hasHandles;
           });
}

void setHandles(Session& session, HandleMode mode) {
    const auto ids = selected(session);
    session.apply({setHandleMode(session.history.settled(), ids, mode), Phase::commit,
                   "Make handles " + std::string(nameOf(mode))});
    session.say("Handles: " + std::string(nameOf(mode)));
}

/// The mode of the first selected anchor, or of the anchor of the first selected handle.
HandleMode presentMode(const Session& session) {
    for (const auto& id : session.view.selection) {
        const auto& entry = session.document().curves[id.curve];
        if (familyOf(*entry).hasHandles) {
            return modeOf(entry, (id.index + 1) / 3 * 3);
        }
    }
    return HandleMode::corner;
}

void deleteHealing(Session& session) {
    const auto ids = selected(session);
    const auto label = "Delete and heal " + nameOf(session.document(), ids);
    session.view.selection.clear(); // the points that move up were not selected
    session.apply({deleteAndHeal(session.history.settled(), ids), Phase::commit, label});
}

std::vector<std::size_t> allPoints(const Curve& curve) {
    std::vector<std::size_t> indices(curve.points.size());
    std::iota(indices.begin(), indices.end(), 0);
    return indices;
}

/// The ids of all control points of the curves from the one numbered `first` on.
std::vector<PointId> pointsFrom(const Document& document, std::size_t first) {
    std::vector<PointId> ids;
    for (std::size_t c = first; c < document.curves.size(); ++c) {
        for (const auto index : allPoints(*document.curves[c])) {
            ids.push_back({c, index, Part::point});
        }
    }
    return ids;
}

bool anyInView(const Session& session, const std::vector<PointId>& ids) {
    const Viewport viewport{session.view.camera, session.canvas};
    PointPlaces places(session.document(), session.view.axes);
    return std::ranges::any_of(ids, [&](const PointId& id) {
        return session.canvas.contains(viewport.toScreen(places[id]));
    });
}

/// Adds curves to the document as one step, selects them, and moves them off what they would hide;
/// shows the whole document where none of them is in view.
void addCopies(Session& session, const std::vector<CurveEntry>& copies, const std::string& label) {
    Document next = session.history.settled();
    const auto first = next.curves.size();
    const bool hidden = std::ranges::any_of(copies, [&](const CurveEntry& copy) {
        return std::ranges::any_of(next.curves, [&](const CurveEntry& old) {
            return !copy->points.empty() && !old->points.empty() &&
                   std::ranges::equal(copy->points[0], old->points[0]);
        });
    });
    next.curves.insert(next.curves.end(), copies.begin(), copies.end());
    const auto ids = pointsFrom(next, first);
    if (hidden) {
        const double step = gridStep(session.view.camera, copyOffset * session.scale);
        next = movedInPlane(next, ids, session.view.axes, step, -step);
    }
    session.apply({std::move(next), Phase::commit, label});
    if (session.document().curves.size() > first) {
        session.view.activeCurve = first;
        session.view.cursor = {};
        session.view.selection = Selection(ids);
        session.view.fitPending |= !anyInView(session, ids);
    }
}

void copy(Session& session) {
    const auto ids = selected(session);
    const std::array active = {session.view.activeCurve};
    const auto text = ids.empty() ? copiedCurves(session.document(), active)
                                  : copiedPoints(session.document(), ids);
    setClipboardText(text);
    session.say("Copied " + (ids.empty() ? "“" + session.active()->curve().name + "”"
                                         : nameOf(session.document(), ids)));
}

void cut(Session& session) {
    copy(session);
    const auto ids = selected(session);
    session.view.selection.clear();
    Document next = ids.empty() ? removeCurve(session.history.settled(), session.view.activeCurve)
                                : deletePoints(session.history.settled(), ids);
    session.apply({std::move(next), Phase::commit, "Cut"});
}

void paste(Session& session) {
    const auto text = clipboardText();
    if (text.empty()) {
        return session.complain("The clipboard is empty.");
    }
    const auto found = pasted(text);
    if (!found) {
        return session.complain("The clipboard holds no curves: " + found.refusal().message());
    }
    addCopies(session, found->curves, "Paste");
}

void duplicate(Session& session) {
    const auto active = session.view.activeCurve;
    const Document doubled = duplicateCurve(session.history.settled(), active);
    addCopies(session, {doubled.curves[active + 1]}, "Duplicate the curve");
}

/// What came of an edit that may be impossible.
void applyIfPossible(Session& session, std::variant<Document, Problem> result,
                     const std::string& label) {
    if (const auto* problem = std::get_if<Problem>(&result)) {
        return session.complain(label + " is not possible: " + problem->what +
                                "; right would be: " + problem->remedy);
    }
    session.view.selection.clear();
    session.apply({std::get<Document>(std::move(result)), Phase::commit, label});
}

bool isEnd(const Document& document, const PointId& id) {
    const Curve& curve = *document.curves[id.curve];
    return id.part == Part::point && !curve.closed &&
           (id.index == 0 || id.index + 1 == curve.points.size());
}

/// Whether two ends are selected: of two curves to be joined, or of one to be closed.
bool twoEnds(const Session& session) {
    return hasSelection(session) && session.view.selection.size() == 2 &&
           std::ranges::all_of(session.view.selection,
                               [&](const PointId& id) { return isEnd(session.document(), id); });
}

void join(Session& session) {
    const auto ids = selected(session);
    if (ids[0].curve == ids[1].curve) {
        return session.apply({setClosed(session.history.settled(), ids[0].curve, true),
                              Phase::commit, "Close the curve"});
    }
    applyIfPossible(session, joinCurves(session.history.settled(), ids[0], ids[1]),
                    "Join the curves");
}

/// At the selected point, otherwise at u.
void split(Session& session) {
    const auto& settled = session.history.settled();
    const auto ids = selected(session);
    if (ids.size() == 1 && ids[0].part == Part::point) {
        return applyIfPossible(session, splitCurve(settled, ids[0]), "Split the curve");
    }
    applyIfPossible(session, splitCurve(settled, session.view.activeCurve, session.view.cursor),
                    "Split the curve");
}

void addHandleCommands(std::vector<Command>& all) {
    all.push_back({"handles.next",
                   "Points",
                   called("Next kind of handles"),
                   {{Key::m}},
                   [](Session& s) { setHandles(s, nextHandleMode(presentMode(s))); },
                   selectionHasHandles});
    all.back().startsGroup = true;
    for (const auto mode :
         {HandleMode::corner, HandleMode::aligned, HandleMode::mirrored, HandleMode::automatic}) {
        const std::string name(nameOf(mode));
        all.push_back({"handles." + name,
                       "Points",
                       called("Handles: " + name),
                       {},
                       [mode](Session& s) { setHandles(s, mode); },
                       selectionHasHandles,
                       [mode](const Session& s) {
                           return selectionHasHandles(s) && presentMode(s) == mode;
                       }});
        all.back().contexts = {Context::point};
    }
}

} // namespace

void addClipboardCommands(std::vector<Command>& all) {
    all.push_back({"edit.cut", "Edit", called("Cut"), {{Key::x, controlKey}}, cut, canEditCurve});
    all.back().startsGroup = true;
    all.back().contexts = {Context::point, Context::curve};
    all.push_back({"edit.copy", "Edit", called("Copy"), {{Key::c, controlKey}}, copy, hasCurve});
    all.back().contexts = {Context::point, Context::curve};
    all.push_back({"edit.paste",
                   "Edit",
                   called("Paste points, curves or an SVG path"),
                   {{Key::v, controlKey}},
                   paste,
                   handsOff});
    all.back().contexts = {Context::canvas};
    all.push_back({"edit.duplicate",
                   "Edit",
                   called("Duplicate the curve"),
                   {{Key::d, controlKey}},
                   duplicate,
                   hasCurve});
    all.back().contexts = {Context::curve};
}

void addPointCommands(std::vector<Command>& all) {
    all.push_back({"points.heal",
                   "Points",
                   called("Delete and heal"),
                   {{Key::del, controlKey}, {Key::backspace, controlKey}},
                   deleteHealing,
                   hasSelection});
    all.back().contexts = {Context::point};
    addHandleCommands(all);
    all.push_back({"curve.join",
                   "Points",
                   called("Join two selected ends"),
                   {{Key::j, controlKey}},
                   join,
                   twoEnds});
    all.back().contexts = {Context::point};
    all.back().startsGroup = true;
    all.push_back({"curve.split",
                   "Points",
                   called("Split the curve at the point, or at u"),
                   {{Key::k, controlKey}},
                   split,
                   [](const Session& s) { return hasPieces(s) && canEditCurve(s); }});
    all.back().contexts = {Context::point, Context::curve};
    all.push_back({"curve.openAt",
                   "Points",
                   called("Open the closed curve at the point"),
                   {},
                   [](Session& s) {
                       applyIfPossible(s, openAt(s.history.settled(), *s.view.selection.begin()),
                                       "Open the curve");
                   },
                   [](const Session& s) {
                       return hasSelection(s) && s.view.selection.size() == 1 &&
                              s.document().curves[s.view.selection.begin()->curve]->closed;
                   }});
    all.back().contexts = {Context::point};
    all.push_back({"curve.reverse",
                   "Points",
                   called("Reverse the curve"),
                   {{Key::r, shiftKey}},
                   [](Session& s) {
                       s.view.selection.clear();
                       s.apply({reverseCurve(s.history.settled(), s.view.activeCurve),
                                Phase::commit, "Reverse the curve"});
                   },
                   canEditCurve});
    all.back().contexts = {Context::curve};
}

} // namespace splineloft::ui
