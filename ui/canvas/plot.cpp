#include "ui/canvas/plot.h"

#include "ui/canvas/wording.h"

#include <algorithm>
#include <cmath>

namespace splineloft::ui {
namespace {

/// Lines at whole numbers, or at every second, fifth, tenth ..., whichever leaves them apart.
double stepFor(double span, double pixels, double least) {
    double step = 1;
    for (int k = 0; step * pixels < least * span; ++k) {
        step *= k % 3 == 1 ? 2.5 : 2;
    }
    return step;
}

void drawAxes(Scene& scene, const PlotFrame& plot, double step, double scale) {
    const auto line = [&](ScreenPoint a, ScreenPoint b) {
        scene.strokes.push_back({{a, b}, {Role::plotAxis}});
    };
    for (const double level : {0.0, 0.5, 1.0}) {
        line(plot.at(plot.left, level), plot.at(plot.right, level));
        scene.labels.push_back({level == 0.5 ? "½" : fixed(level, 0),
                                {plot.frame.left - 16 * scale, plot.at(0, level).y},
                                0,
                                {Role::plotText},
                                true,
                                true});
    }
    for (double x = plot.left; x <= plot.right + 1e-9 * step; x += step) {
        line(plot.at(x, plot.low), plot.at(x, plot.high));
        scene.labels.push_back({decimal(x, step < 1 ? step : 1),
                                {plot.at(x, 0).x - 4 * scale, plot.frame.bottom() + 9 * scale},
                                0,
                                {Role::plotText},
                                true,
                                true});
    }
}

void drawCursor(Scene& scene, const PlotFrame& plot, double x) {
    scene.strokes.push_back({{plot.at(x, plot.low), plot.at(x, plot.high)}, {Role::plotCursor}});
}

/// Tangents follow the points in the count of controls; they wear their point's colour.
Ink inkOf(const Study& study, std::size_t control) {
    const auto n = study.curve().points.size();
    return control < n ? Ink{Role::basis, static_cast<int>(control)}
                       : Ink{Role::tangentBasis, static_cast<int>(control - n)};
}

bool isEmphasised(const Emphasis& emphasis, std::size_t control) {
    return emphasis.control == control;
}

} // namespace

ScreenPoint PlotFrame::at(double x, double y) const {
    const double part = right > left ? (x - left) / (right - left) : 0.5;
    return {frame.left + frame.width * part,
            frame.bottom() - frame.height * (y - low) / (high - low)};
}

double PlotFrame::across(double pixel) const {
    const double part = std::clamp((pixel - frame.left) / frame.width, 0.0, 1.0);
    return lerp(left, right, part);
}

PlotFrame wholeRangeFrame(const Study& study, const ScreenRect& frame) {
    const auto& graph = study.basisGraph();
    const auto& knots = study.pieces().knots();
    return {frame, knots.start(), knots.end(), std::min(graph.low, 0.0) - 0.04,
            std::max(graph.high, 1.0) + 0.04};
}

PlotFrame segmentFrame(const Study& study, const ScreenRect& frame) {
    PlotFrame plot = wholeRangeFrame(study, frame);
    plot.left = 0;
    plot.right = 1;
    return plot;
}

void drawBasis(Scene& scene, const PlotFrame& plot, const Study& study, Spot cursor,
               const Emphasis& emphasis, double scale) {
    const auto& knots = study.pieces().knots();
    const auto& joints = knots.knots();
    const ScreenPoint start = plot.at(joints[cursor.segment], plot.high);
    const ScreenPoint end = plot.at(joints[cursor.segment + 1], plot.low);
    scene.areas.push_back({{start.x, start.y, end.x - start.x, end.y - start.y}, {Role::plotBand}});
    const double step = stepFor(plot.right - plot.left, plot.frame.width, 44 * scale);
    drawAxes(scene, plot, step, scale);
    for (const auto& run : study.basisGraph().runs) {
        SceneStroke stroke{{}, inkOf(study, run.control)};
        stroke.emphasised = isEmphasised(emphasis, run.control);
        for (const auto& [spot, weight] : run.values) {
            stroke.points.push_back(plot.at(knots.parameter(spot), weight));
        }
        scene.strokes.push_back(std::move(stroke));
    }
    drawCursor(scene, plot, knots.parameter(cursor));
    const Blend now = study.blends()->basis(cursor);
    for (const auto& [control, weight] : now.shares()) {
        scene.marks.push_back(
            {plot.at(knots.parameter(cursor), weight), SignShape::disc, inkOf(study, control)});
    }
}

void drawSegments(Scene& scene, const PlotFrame& plot, const Study& study, Spot cursor,
                  const Emphasis& emphasis, double scale) {
    drawAxes(scene, plot, 0.5, scale);
    for (const auto& run : study.basisGraph().runs) {
        SceneStroke stroke{{}, inkOf(study, run.control)};
        stroke.emphasised = isEmphasised(emphasis, run.control);
        for (const auto& [spot, weight] : run.values) {
            if (spot.segment == cursor.segment) {
                stroke.points.push_back(plot.at(spot.u, weight));
            }
        }
        if (!stroke.points.empty()) {
            scene.strokes.push_back(std::move(stroke));
        }
    }
    drawCursor(scene, plot, cursor.u);
    const Blend now = study.blends()->basis(cursor);
    for (const auto& [control, weight] : now.shares()) {
        scene.marks.push_back({plot.at(cursor.u, weight), SignShape::disc, inkOf(study, control)});
    }
}

} // namespace splineloft::ui
