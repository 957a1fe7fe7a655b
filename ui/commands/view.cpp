// The View menu.
#include "ui/commands/menus.h"

#include "ui/canvas/viewport.h"

#include <algorithm>
#include <array>
#include <iterator>

namespace splineloft::ui {
namespace {

void zoomAtMiddle(Session& session, double factor) {
    const auto& frame = session.canvas;
    const ScreenPoint middle{frame.left + frame.width / 2, frame.top + frame.height / 2};
    session.view.camera = zoomed({session.view.camera, frame}, middle, factor);
}

// How much larger or smaller everything may be than it usually is.
constexpr std::array interfaceScales = {0.75, 0.9, 1.0, 1.1, 1.25, 1.5, 1.75, 2.0};

void enlarge(Session& session) {
    auto& scale = session.view.interfaceScale;
    const auto* next = std::ranges::upper_bound(interfaceScales, scale);
    scale = next == interfaceScales.end() ? interfaceScales.back() : *next;
}

void reduce(Session& session) {
    auto& scale = session.view.interfaceScale;
    const auto* next = std::ranges::lower_bound(interfaceScales, scale);
    scale = next == interfaceScales.begin() ? interfaceScales.front() : *std::prev(next);
}

void addLayer(std::vector<Command>& all, std::string id, std::string name, Shortcut shortcut,
              bool Layers::* layer) {
    all.push_back({"view." + id,
                   "View",
                   called(std::move(name)),
                   {shortcut},
                   [layer](Session& s) { s.view.layers.*layer = !(s.view.layers.*layer); },
                   [](const Session&) { return true; },
                   [layer](const Session& s) { return s.view.layers.*layer; }});
}

/// Shows a plot, also where no strip or the messages were shown.
void addPlot(std::vector<Command>& all, std::string id, std::string name, Shortcut shortcut,
             Plot plot) {
    all.push_back({"plot." + id,
                   "View",
                   called(std::move(name)),
                   {shortcut},
                   [plot](Session& s) {
                       s.view.plot = plot;
                       s.view.layers.basis = true;
                       s.view.log = false;
                   },
                   [](const Session&) { return true; },
                   [plot](const Session& s) { return s.view.plot == plot; }});
    all.back().submenu = "Plot";
}

void addPlots(std::vector<Command>& all) {
    addPlot(all, "basis", "Plot the basis functions", {Key::h, shiftKey}, Plot::basis);
    addPlot(all, "speed", "Plot the speed", {Key::s, shiftKey}, Plot::speed);
    addPlot(all, "acceleration", "Plot the acceleration", {Key::a, shiftKey}, Plot::acceleration);
    addPlot(all, "curvature", "Plot the curvature", {Key::k, shiftKey}, Plot::curvature);
}

void addSizes(std::vector<Command>& all) {
    all.push_back(
        {"view.larger",
         "View",
         called("Larger interface"),
         {{Key::equal, controlKey}, {Key::equal, controlShiftKeys}},
         enlarge,
         [](const Session& s) { return s.view.interfaceScale < interfaceScales.back(); }});
    all.push_back(
        {"view.smaller",
         "View",
         called("Smaller interface"),
         {{Key::minus, controlKey}},
         reduce,
         [](const Session& s) { return s.view.interfaceScale > interfaceScales.front(); }});
    all.push_back({"view.usualSize",
                   "View",
                   called("Usual size"),
                   {},
                   [](Session& s) { s.view.interfaceScale = 1; },
                   [](const Session& s) { return s.view.interfaceScale != 1; }});
}

} // namespace

void addViewCommands(std::vector<Command>& all) {
    all.push_back({"view.fit",
                   "View",
                   called("Fit"),
                   {{Key::f}, {Key::home}, {Key::digit0, controlKey}},
                   [](Session& s) { s.view.fitPending = true; }});
    all.back().contexts = {Context::canvas};
    all.push_back({"view.zoomIn",
                   "View",
                   called("Zoom in"),
                   {{Key::equal, shiftKey}, {Key::equal}},
                   [](Session& s) { zoomAtMiddle(s, 1.25); }});
    all.back().repeats = true;
    all.push_back({"view.zoomOut", "View", called("Zoom out"), {{Key::minus}}, [](Session& s) {
                       zoomAtMiddle(s, 0.8);
                   }});
    all.back().repeats = true;
    addLayer(all, "polygon", "Control polygon", {Key::g}, &Layers::polygon);
    all.back().startsGroup = true;
    addLayer(all, "labels", "Names", {Key::n}, &Layers::labels);
    addLayer(all, "ladder", "de Casteljau's ladder", {Key::l}, &Layers::ladder);
    addLayer(all, "comb", "Curvature comb", {Key::k}, &Layers::comb);
    addLayer(all, "beads", "Beads", {Key::b}, &Layers::beads);
    addLayer(all, "joints", "Joints", {Key::j}, &Layers::joints);
    addLayer(all, "frames", "Frames", {Key::r}, &Layers::frames);
    addLayer(all, "basis", "Strip of plots", {Key::h}, &Layers::basis);
    addPlots(all);
    addLayer(all, "grid", "Grid", {Key::g, shiftKey}, &Layers::grid);
    all.back().startsGroup = true;
    all.back().contexts = {Context::canvas};
    addLayer(all, "gridNumbers", "Numbers at the grid", {Key::n, shiftKey}, &Layers::gridNumbers);
    all.back().contexts = {Context::canvas};
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
    addSizes(all);
    all.push_back({"view.present",
                   "View",
                   called("Present"),
                   {{Key::f11}},
                   [](Session& s) { s.present(!s.view.presenting); },
                   [](const Session&) { return true; },
                   [](const Session& s) { return s.view.presenting; }});
    all.back().startsGroup = true;
    all.back().contexts = {Context::canvas};
    all.push_back({"view.log",
                   "View",
                   called("Messages"),
                   {},
                   [](Session& s) { s.view.log = !s.view.log; },
                   [](const Session&) { return true; },
                   [](const Session& s) { return s.view.log; }});
}

} // namespace splineloft::ui
