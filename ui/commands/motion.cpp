// The Motion and Help menus.
#include "ui/commands/menus.h"

#include "ui/travel.h"

namespace splineloft::ui {
namespace {

// A key steps the traveller by so much of the way.
constexpr double stepPart = 0.01;

bool canStep(const Session& session) {
    return hasPieces(session) && (session.view.playing || session.view.selection.empty());
}

void addSteps(std::vector<Command>& all) {
    const auto add = [&all](std::string id, std::string name, Key key, double part) {
        all.push_back({std::move(id),
                       "Motion",
                       called(std::move(name)),
                       {{key}},
                       [part](Session& s) {
                           if (s.view.playing) {
                               s.view.selection.clear(); // or the next arrow would nudge it
                           }
                           s.view.playing = false;
                           travel(s, part);
                       },
                       canStep});
        all.back().repeats = true;
    };
    add("motion.stepBack", "Step back", Key::left, -stepPart);
    add("motion.stepOn", "Step on", Key::right, stepPart);
}

} // namespace

void addMotionCommands(std::vector<Command>& all) {
    all.push_back({"motion.play",
                   "Motion",
                   called("Play"),
                   {{Key::space}},
                   [](Session& s) { s.view.playing = !s.view.playing; },
                   [](const Session& s) { return hasCurve(s) && !s.active()->pieces().empty(); },
                   [](const Session& s) { return s.view.playing; }});
    all.back().onTap = true; // held down, Space moves the view
    addSteps(all);
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
    all.push_back({"help.palette",
                   "Help",
                   called("Find a command…"),
                   {{Key::p, controlShiftKeys}},
                   [](Session& s) { s.dialog = Palette{}; }});
    all.push_back({"help.keys", "Help", called("Keys and mouse"), {{Key::f1}}, [](Session& s) {
                       s.dialog = KeyList{};
                   }});
    all.push_back({"help.shortcutsFile", "Help", called("Shortcuts file…"), {}, [](Session& s) {
                       s.requests.emplace_back(MakeShortcutsFile{});
                   }});
    all.back().startsGroup = true;
    all.push_back(
        {"help.readShortcuts", "Help", called("Read the shortcuts again"), {}, [](Session& s) {
             s.requests.emplace_back(ReadShortcuts{});
         }});
}

} // namespace splineloft::ui
