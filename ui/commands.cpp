#include "ui/commands.h"

#include "core/document/edits.h"
#include "core/spline/catalog.h"
#include "core/spline/change/convert.h"
#include "ui/canvas/grid.h"
#include "ui/canvas/hints.h"
#include "ui/canvas/viewport.h"

#include <algorithm>
#include <stdexcept>

namespace splineloft::ui {
namespace {

constexpr Modifiers control{.control = true};
constexpr Modifiers shift{.shift = true};
constexpr Modifiers controlShift{.shift = true, .control = true};

auto called(std::string name) {
    return [name = std::move(name)](const Session&) { return name; };
}

/// Keys edit what is settled; while a hand shows what is not, they wait.
bool handsOff(const Session& session) {
    return !session.history.previewing();
}
bool hasCurve(const Session& session) {
    return session.active() != nullptr && handsOff(session);
}
bool hasSelection(const Session& session) {
    return !session.view.selection.empty() && handsOff(session);
}

std::vector<PointId> selected(const Session& session) {
    return {session.view.selection.begin(), session.view.selection.end()};
}

void deleteSelection(Session& session) {
    const auto ids = selected(session);
    const auto label = "Delete " + nameOf(session.document(), ids);
    session.view.selection.clear(); // the points that move up were not selected
    session.apply({deletePoints(session.history.settled(), ids), Phase::commit, label});
}

void selectAll(Session& session) {
    session.view.selection.clear();
    const auto count = session.active()->curve().points.size();
    for (std::size_t i = 0; i < count; ++i) {
        session.view.selection.insert({session.view.activeCurve, i, Part::point});
    }
}

/// Esc: whatever is under way ends, else the tool, else the selection.
void stepBack(Session& session) {
    if (!std::holds_alternative<Idle>(session.gesture)) {
        session.giveUpGesture();
    } else if (session.view.tool != Tool::select) {
        session.view.tool = Tool::select;
    } else {
        session.view.selection.clear();
    }
}

void zoomAtMiddle(Session& session, double factor) {
    const auto& frame = session.canvas;
    const ScreenPoint middle{frame.left + frame.width / 2, frame.top + frame.height / 2};
    session.view.camera = zoomed({session.view.camera, frame}, middle, factor);
}

/// Moves the selection by so many tenths of a fine grid step.
void nudge(Session& session, double right, double up, double tenths) {
    const double step = tenths * fineGridStep(session.view.camera, session.scale) / 10;
    const auto ids = selected(session);
    session.apply(
        {movedInPlane(session.history.settled(), ids, session.view.axes, right * step, up * step),
         Phase::commit, "Nudge " + nameOf(session.document(), ids)});
}

bool hasPieces(const Session& session) {
    return hasCurve(session) && !session.active()->pieces().empty();
}

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

void addFileCommands(std::vector<Command>& all) {
    all.push_back({"file.new", "File", called("New"), {{Key::n, control}}, [](Session& s) {
                       s.leave(StartNew{});
                   }});
    all.push_back({"file.open", "File", called("Open…"), {{Key::o, control}}, [](Session& s) {
                       s.leave(GoToFile{});
                   }});
    all.push_back(
        {"file.save", "File", called("Save"), {{Key::s, control}}, [](Session& s) { s.save(); }});
    all.back().startsGroup = true;
    all.push_back(
        {"file.saveAs", "File", called("Save as…"), {{Key::s, controlShift}}, [](Session& s) {
             s.browse(FilePurpose::save);
         }});
    all.push_back({"file.export",
                   "File",
                   called("Export samples…"),
                   {{Key::e, control}},
                   [](Session& s) { s.browse(FilePurpose::exportSamples); },
                   [](const Session& s) { return hasCurve(s) && !s.active()->pieces().empty(); }});
    all.push_back({"file.quit", "File", called("Quit"), {{Key::q, control}}, [](Session& s) {
                       s.leave(Quit{});
                   }});
    all.back().startsGroup = true;
}

void addEditCommands(std::vector<Command>& all) {
    all.push_back({"edit.undo",
                   "Edit",
                   [](const Session& s) { return "Undo " + std::string(s.history.undoLabel()); },
                   {{Key::z, control}},
                   [](Session& s) { s.undo(); },
                   [](const Session& s) { return s.history.canUndo() || s.history.previewing(); }});
    all.back().repeats = true;
    all.push_back({"edit.redo",
                   "Edit",
                   [](const Session& s) { return "Redo " + std::string(s.history.redoLabel()); },
                   {{Key::y, control}, {Key::z, controlShift}},
                   [](Session& s) { s.redo(); },
                   [](const Session& s) { return s.history.canRedo(); }});
    all.back().repeats = true;
    all.push_back({"edit.delete",
                   "Edit",
                   called("Delete points"),
                   {{Key::del}, {Key::backspace}},
                   deleteSelection,
                   hasSelection});
    all.back().startsGroup = true;
    all.push_back({"edit.selectAll",
                   "Edit",
                   called("Select all points of the curve"),
                   {{Key::a, control}},
                   selectAll,
                   hasCurve});
    all.push_back({"edit.escape",
                   "Edit",
                   called("Cancel, or clear the selection"),
                   {{Key::escape}},
                   stepBack});
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
                       hasSelection});
        all.back().repeats = true;
        all.push_back({"edit.nudgeFar." + name,
                       "",
                       called("Nudge " + name + " ten times as far"),
                       {{way.key, shift}},
                       [way](Session& s) { nudge(s, way.right, way.up, 10); },
                       hasSelection});
        all.back().repeats = true;
    }
}

void addLayer(std::vector<Command>& all, std::string id, std::string name, Key key,
              bool Layers::* layer) {
    all.push_back({"view." + id,
                   "View",
                   called(std::move(name)),
                   {{key}},
                   [layer](Session& s) { s.view.layers.*layer = !(s.view.layers.*layer); },
                   [](const Session&) { return true; },
                   [layer](const Session& s) { return s.view.layers.*layer; }});
}

void addViewCommands(std::vector<Command>& all) {
    all.push_back({"view.fit",
                   "View",
                   called("Fit"),
                   {{Key::f}, {Key::home}, {Key::digit0, control}},
                   [](Session& s) { s.view.fitPending = true; }});
    all.push_back({"view.zoomIn",
                   "View",
                   called("Zoom in"),
                   {{Key::equal}, {Key::equal, shift}},
                   [](Session& s) { zoomAtMiddle(s, 1.25); }});
    all.back().repeats = true;
    all.push_back({"view.zoomOut", "View", called("Zoom out"), {{Key::minus}}, [](Session& s) {
                       zoomAtMiddle(s, 0.8);
                   }});
    all.back().repeats = true;
    addLayer(all, "polygon", "Control polygon", Key::g, &Layers::polygon);
    all.back().startsGroup = true;
    addLayer(all, "labels", "Names", Key::n, &Layers::labels);
    addLayer(all, "ladder", "de Casteljau's ladder", Key::l, &Layers::ladder);
    addLayer(all, "comb", "Curvature comb", Key::k, &Layers::comb);
    addLayer(all, "beads", "Beads", Key::b, &Layers::beads);
    addLayer(all, "joints", "Joints", Key::j, &Layers::joints);
    addLayer(all, "basis", "Basis functions", Key::h, &Layers::basis);
    all.push_back({"view.light",
                   "View",
                   called("Light theme"),
                   {{Key::t}},
                   [](Session& s) {
                       const bool dark = s.view.theme == ThemeKind::dark;
                       s.view.theme = dark ? ThemeKind::light : ThemeKind::dark;
                   },
                   [](const Session&) { return true; },
                   [](const Session& s) { return s.view.theme == ThemeKind::light; }});
    all.back().startsGroup = true;
}

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
    all.push_back({"curve.new",
                   "Curve",
                   called("Pen: begin another curve"),
                   {{Key::p, shift}},
                   [](Session& s) { s.view.tool = Tool::newCurve; },
                   [](const Session&) { return true; },
                   [](const Session& s) { return s.view.tool == Tool::newCurve; }});
    all.push_back({"tool.endPen",
                   "",
                   called("End the pen"),
                   {{Key::enter}, {Key::keypadEnter}},
                   [](Session& s) { s.view.tool = Tool::select; },
                   [](const Session& s) { return s.view.tool != Tool::select; }});
    all.push_back({"curve.closed",
                   "Curve",
                   called("Closed"),
                   {{Key::c}},
                   [](Session& s) {
                       const bool closed = s.active()->curve().closed;
                       s.apply({setClosed(s.history.settled(), s.view.activeCurve, !closed),
                                Phase::commit, closed ? "Open the curve" : "Close the curve"});
                   },
                   [](const Session& s) { return hasCurve(s) && s.active()->family().closable; },
                   [](const Session& s) { return hasCurve(s) && s.active()->curve().closed; }});
    all.back().startsGroup = true;
    all.push_back({"curve.toBezierSpline",
                   "Curve",
                   called("Turn into a Bézier spline of the same shape"),
                   {},
                   turnIntoBezierSpline,
                   hasPieces});
    all.push_back({"curve.graph",
                   "Curve",
                   called("Parabola as the graph y = f(x)"),
                   {},
                   makeGraph,
                   [](const Session& s) {
                       if (!hasPieces(s)) {
                           return false;
                       }
                       const Curve& curve = s.active()->curve();
                       return curve.family == "parametric-parabola" && curve.points.size() == 3 &&
                              curve.points.dimension() > 1;
                   }});
    all.push_back({"curve.delete",
                   "Curve",
                   called("Delete the curve"),
                   {{Key::del, shift}},
                   [](Session& s) {
                       s.view.selection.clear(); // the curves that move up were not selected
                       s.apply({removeCurve(s.history.settled(), s.view.activeCurve), Phase::commit,
                                "Delete the curve"});
                   },
                   hasCurve});
    int digit = 0;
    for (const auto& family : catalog()) {
        ++digit;
        const std::string id(family.id);
        const std::string name(family.name);
        std::vector<Shortcut> shortcuts;
        if (digit <= 9) {
            shortcuts.push_back({static_cast<Key>(static_cast<int>(Key::digit0) + digit)});
        }
        all.push_back(
            {"family." + id, "Family", called(name), shortcuts,
             [id, name](Session& s) {
                 s.apply({setFamily(s.history.settled(), s.view.activeCurve, id), Phase::commit,
                          "Draw as " + name});
             },
             hasCurve,
             [id](const Session& s) { return hasCurve(s) && s.active()->curve().family == id; }});
    }
}

void addMotionCommands(std::vector<Command>& all) {
    all.push_back({"motion.play",
                   "Motion",
                   called("Play"),
                   {{Key::space}},
                   [](Session& s) { s.view.playing = !s.view.playing; },
                   [](const Session& s) { return hasCurve(s) && !s.active()->pieces().empty(); },
                   [](const Session& s) { return s.view.playing; }});
    all.push_back({"motion.length",
                   "Motion",
                   called("Constant speed (even in length)"),
                   {},
                   [](Session& s) { s.view.pace = Even::length; },
                   [](const Session&) { return true; },
                   [](const Session& s) { return s.view.pace == Even::length; }});
    all.back().startsGroup = true;
    all.push_back({"motion.parameter",
                   "Motion",
                   called("Even in u"),
                   {},
                   [](Session& s) { s.view.pace = Even::parameter; },
                   [](const Session&) { return true; },
                   [](const Session& s) { return s.view.pace == Even::parameter; }});
    all.push_back({"motion.swap",
                   "",
                   called("Change between even in length and in u"),
                   {{Key::e}},
                   [](Session& s) {
                       s.view.pace = s.view.pace == Even::length ? Even::parameter : Even::length;
                   }});
    all.push_back({"help.keys", "Help", called("Keys and mouse"), {{Key::f1}}, [](Session& s) {
                       s.dialog = KeyList{};
                   }});
}

std::vector<Command> allCommands() {
    std::vector<Command> all;
    addFileCommands(all);
    addEditCommands(all);
    addNudges(all);
    addViewCommands(all);
    addCurveCommands(all);
    addMotionCommands(all);
    return all;
}

std::string nameOf(Key key) {
    const int code = static_cast<int>(key);
    if (code > ' ' && code < 128) {
        return key == Key::equal ? "+" : std::string(1, static_cast<char>(code));
    }
    switch (key) {
    case Key::space: return "Space";
    case Key::escape: return "Esc";
    case Key::enter: return "Enter";
    case Key::keypadEnter: return "Enter (keypad)";
    case Key::backspace: return "Backspace";
    case Key::del: return "Delete";
    case Key::home: return "Home";
    case Key::left: return "←";
    case Key::right: return "→";
    case Key::up: return "↑";
    case Key::down: return "↓";
    case Key::f1: return "F1";
    default: return "key " + std::to_string(code);
    }
}

} // namespace

std::string nameOf(const Shortcut& shortcut) {
    return std::string(shortcut.modifiers.control ? "Ctrl+" : "") +
           (shortcut.modifiers.alt ? "Alt+" : "") +
           (shortcut.modifiers.shift && shortcut.key != Key::equal ? "Shift+" : "") +
           nameOf(shortcut.key);
}

std::span<const Command> commands() {
    static const auto all = allCommands();
    return all;
}

const Command& commandNamed(std::string_view id) {
    const auto found = std::ranges::find(commands(), id, &Command::id);
    if (found == commands().end()) {
        throw std::out_of_range("there is no command " + std::string(id));
    }
    return *found;
}

bool runShortcut(Session& session, const Shortcut& shortcut, Strike strike) {
    for (const auto& command : commands()) {
        const bool named =
            std::ranges::find(command.shortcuts, shortcut) != command.shortcuts.end();
        const bool due = strike == Strike::fresh || command.repeats;
        if (named && due && command.possible(session)) {
            command.run(session);
            return true;
        }
    }
    return false;
}

} // namespace splineloft::ui
