// The Curve and Family menus.
#include "ui/commands/menus.h"

#include "core/document/curve_edits.h"
#include "core/document/edits.h"
#include "core/spline/catalog.h"
#include "core/spline/change/convert.h"

namespace splineloft::ui {
namespace {

/// The same curve with its Bézier points as anchors and handles; says why where it has too high a
/// degree.
void turnIntoBezierSpline(Session& session) {
    auto result = converted(session.active()->curve(), "bezier-spline");
    if (const auto* problem = std::get_if<Problem>(&result)) {
        return session.complain("A Bézier spline of the same shape is not possible: " +
                                problem->what + "; right would be: " + problem->remedy);
    }
    Document next = session.history.settled();
    next.curves[session.view.activeCurve] =
        std::make_shared<Curve>(std::get<Curve>(std::move(result)));
    session.view.selection.clear();
    session.apply({std::move(next), Phase::commit, "Turn into a Bézier spline"});
}

/// Of the parabolas through three points the one that is a graph over x reaches the middle point at
/// mu = (x1 - x0) / (x2 - x0) (lecture, figure 1).
void makeGraph(Session& session) {
    const Points& points = session.active()->curve().points;
    const double mu = (points[1][0] - points[0][0]) / (points[2][0] - points[0][0]);
    if (!(mu > 0 && mu < 1)) {
        return session.complain("y = f(x) needs the middle point's x between those of the others");
    }
    session.apply({setParameter(session.history.settled(), session.view.activeCurve, "mu", mu),
                   Phase::commit, "Make it y = f(x)"});
}

/// Another family for the active curve, or for the first one to come.
void drawAs(Session& session, const std::string& family, const std::string& name) {
    if (hasCurve(session)) {
        session.apply({setFamily(session.history.settled(), session.view.activeCurve, family),
                       Phase::commit, "Draw as " + name});
    } else {
        session.view.firstFamily = family;
    }
}

/// Another look for the active curve.
template <class Change> void look(Session& session, Change change, const std::string& label) {
    const auto curve = session.view.activeCurve;
    Look next = session.document().curves[curve].look;
    change(next);
    session.apply({setLook(session.history.settled(), curve, next), Phase::commit, label});
}

const Look& activeLook(const Session& session) {
    return session.document().curves[session.view.activeCurve].look;
}

void addLooks(std::vector<Command>& all) {
    all.push_back({"curve.rename",
                   "Curve",
                   called("Rename the curve"),
                   {{Key::f2}},
                   [](Session& s) { s.view.renaming = Renaming{s.view.activeCurve}; },
                   [](const Session& s) { return canEditCurve(s) && !s.view.presenting; }});
    all.back().startsGroup = true;
    all.back().contexts = {Context::curve};
    all.push_back({"curve.visible",
                   "Curve",
                   called("Show the curve"),
                   {},
                   [](Session& s) {
                       look(
                           s, [](Look& l) { l.visible = !l.visible; },
                           activeLook(s).visible ? "Hide the curve" : "Show the curve");
                   },
                   hasCurve,
                   [](const Session& s) { return hasCurve(s) && activeLook(s).visible; }});
    all.back().contexts = {Context::curve};
    all.push_back({"curve.locked",
                   "Curve",
                   called("Lock the curve"),
                   {},
                   [](Session& s) {
                       look(
                           s, [](Look& l) { l.locked = !l.locked; },
                           activeLook(s).locked ? "Unlock the curve" : "Lock the curve");
                   },
                   hasCurve,
                   [](const Session& s) { return hasCurve(s) && activeLook(s).locked; }});
    all.back().contexts = {Context::curve};
    all.push_back({"curve.colour",
                   "Curve",
                   called("Next colour"),
                   {},
                   [](Session& s) {
                       look(
                           s, [](Look& l) { l.colour = (l.colour + 1) % (curveColours + 1); },
                           "Colour the curve");
                   },
                   hasCurve});
    all.back().contexts = {Context::curve};
}

} // namespace

void addCurveCommands(std::vector<Command>& all) {
    all.push_back({"tool.select",
                   "Curve",
                   called("Select and move"),
                   {{Key::v}},
                   [](Session& s) { s.view.tool = Tool::select; },
                   [](const Session&) { return true; },
                   [](const Session& s) { return s.view.tool == Tool::select; }});
    all.push_back({"tool.pen",
                   "Curve",
                   called("Pen: add points at the end"),
                   {{Key::p}},
                   [](Session& s) { s.view.tool = Tool::pen; },
                   [](const Session&) { return true; },
                   [](const Session& s) { return s.view.tool == Tool::pen; }});
    all.back().contexts = {Context::canvas};
    all.push_back({"curve.new",
                   "Curve",
                   called("Pen: begin another curve"),
                   {{Key::p, shiftKey}},
                   [](Session& s) { s.view.tool = Tool::newCurve; },
                   [](const Session&) { return true; },
                   [](const Session& s) { return s.view.tool == Tool::newCurve; }});
    all.back().contexts = {Context::canvas};
    all.push_back({"tool.endPen",
                   "",
                   called("End the pen"),
                   {{Key::enter}, {Key::keypadEnter}},
                   [](Session& s) { s.view.tool = Tool::select; },
                   [](const Session& s) { return s.view.tool != Tool::select; }});
    all.push_back(
        {"curve.closed",
         "Curve",
         called("Closed"),
         {{Key::c}},
         [](Session& s) {
             const bool closed = s.active()->curve().closed;
             s.apply({setClosed(s.history.settled(), s.view.activeCurve, !closed), Phase::commit,
                      closed ? "Open the curve" : "Close the curve"});
         },
         [](const Session& s) { return canEditCurve(s) && s.active()->family().closable; },
         [](const Session& s) { return hasCurve(s) && s.active()->curve().closed; }});
    all.back().startsGroup = true;
    all.back().contexts = {Context::point, Context::curve};
    all.push_back({"curve.toBezierSpline",
                   "Curve",
                   called("Turn into a Bézier spline of the same shape"),
                   {},
                   turnIntoBezierSpline,
                   [](const Session& s) { return hasPieces(s) && canEditCurve(s); }});
    all.back().contexts = {Context::curve};
    all.push_back({"curve.graph",
                   "Curve",
                   called("Parabola as the graph y = f(x)"),
                   {},
                   makeGraph,
                   [](const Session& s) {
                       if (!hasPieces(s) || !canEditCurve(s)) {
                           return false;
                       }
                       const Curve& curve = s.active()->curve();
                       return curve.family == "parametric-parabola" && curve.points.size() == 3 &&
                              curve.points.dimension() > 1;
                   }});
    all.push_back({"curve.delete",
                   "Curve",
                   called("Delete the curve"),
                   {{Key::del, shiftKey}},
                   [](Session& s) {
                       s.view.selection.clear(); // the curves that move up were not selected
                       s.apply({removeCurve(s.history.settled(), s.view.activeCurve), Phase::commit,
                                "Delete the curve"});
                   },
                   canEditCurve});
    all.back().contexts = {Context::curve};
    addLooks(all);
    int digit = 0;
    for (const auto& family : catalog()) {
        ++digit;
        const std::string id(family.id);
        const std::string name(family.name);
        std::vector<Shortcut> shortcuts;
        if (digit <= 9) {
            shortcuts.push_back({static_cast<Key>(static_cast<int>(Key::digit0) + digit)});
        }
        all.push_back({"family." + id, "Family", called(name), shortcuts,
                       [id, name](Session& s) { drawAs(s, id, name); },
                       [](const Session& s) { return !hasCurve(s) || canEditCurve(s); },
                       [id](const Session& s) {
                           return (hasCurve(s) ? s.active()->curve().family : s.view.firstFamily) ==
                                  id;
                       }});
        all.back().contexts = {Context::point, Context::curve};
    }
}

} // namespace splineloft::ui
