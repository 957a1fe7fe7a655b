// The File menu.
#include "ui/commands/menus.h"

namespace splineloft::ui {

void addFileCommands(std::vector<Command>& all) {
    all.push_back({"file.new", "File", called("New"), {{Key::n, controlKey}}, [](Session& s) {
                       s.leave(StartNew{});
                   }});
    all.push_back({"file.open", "File", called("Open…"), {{Key::o, controlKey}}, [](Session& s) {
                       s.leave(GoToFiles{});
                   }});
    all.push_back({"file.save", "File", called("Save"), {{Key::s, controlKey}}, [](Session& s) {
                       s.save();
                   }});
    all.back().startsGroup = true;
    all.push_back(
        {"file.saveAs", "File", called("Save as…"), {{Key::s, controlShiftKeys}}, [](Session& s) {
             s.browse(FilePurpose::save);
         }});
    all.push_back({"file.export",
                   "File",
                   called("Export samples…"),
                   {{Key::e, controlKey}},
                   [](Session& s) { s.browse(FilePurpose::exportSamples); },
                   [](const Session& s) { return hasCurve(s) && !s.active()->pieces().empty(); }});
    all.push_back({"file.systemDialogs",
                   "File",
                   called("Choose files in the system's dialog"),
                   {},
                   [](Session& s) { s.habits.systemDialogs = !s.habits.systemDialogs; },
                   [](const Session& s) { return s.systemDialogsFound; },
                   [](const Session& s) { return s.habits.systemDialogs; }});
    all.back().startsGroup = true;
    all.push_back({"file.unsavedWork",
                   "File",
                   called("Unsaved work of earlier…"),
                   {},
                   [](Session& s) { s.dialog = RecoveryOffer{}; },
                   [](const Session& s) { return !s.unsavedWork.empty(); }});
    all.push_back({"file.quit", "File", called("Quit"), {{Key::q, controlKey}}, [](Session& s) {
                       s.leave(Quit{});
                   }});
    all.back().startsGroup = true;
}

} // namespace splineloft::ui
