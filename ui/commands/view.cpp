// The View menu.
#include "ui/commands/menus.h"

#include "ui/canvas/viewport.h"

namespace splineloft::ui {
namespace {

void zoomAtMiddle(Session& session, double factor) {
    const auto& frame = session.canvas;
    const ScreenPoint middle{frame.left + frame.width / 2, frame.top + frame.height / 2};
    session.view.camera = zoomed({session.view.camera, frame}, middle, factor);
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

} // namespace

void addViewCommands(std::vector<Command>& all) {
    all.push_back({"view.fit",
                   "View",
                   called("Fit"),
                   {{Key::f}, {Key::home}, {Key::digit0, controlKey}},
                   [](Session& s) { s.view.fitPending = true; }});
    all.push_back({"view.zoomIn",
                   "View",
                   called("Zoom in"),
                   {{Key::equal}, {Key::equal, shiftKey}},
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

} // namespace splineloft::ui
