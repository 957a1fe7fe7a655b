// The Motion and Help menus.
#include "ui/commands/menus.h"

namespace splineloft::ui {

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

} // namespace splineloft::ui
