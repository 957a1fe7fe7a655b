#include "ui/canvas/motion_plot.h"

#include "ui/canvas/ticks.h"
#include "ui/canvas/wording.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace splineloft::ui {
namespace {

// Design pixels.
constexpr double betweenTicksUp = 24;
constexpr double betweenTicksAcross = 52;
constexpr double betweenJoints = 6; // on average, or they are left out
constexpr double tickLength = 4;
constexpr double pointerInset = 6; // of a triangle from the edge that it points at

constexpr double withoutRim = 0.99; // of a triangle's size: a rim would leave little of it

constexpr double spareRange = 0.06; // of the range, beyond its ends

/// Calls `use(multiple of step)` from `low` to `high`.
template <class Use> void eachTick(double low, double high, double step, Use use) {
    const double first = std::ceil(low / step - 1e-9);
    const double last = std::floor(high / step + 1e-9);
    for (double k = first; k <= last; ++k) {
        use(k * step);
    }
}

SceneLabel tickLabel(std::string text, ScreenPoint at, double anchor) {
    SceneLabel label{std::move(text), at, 0, {Role::plotText}, true, true};
    label.anchor = anchor;
    return label;
}

void line(Scene& scene, ScreenPoint from, ScreenPoint to, Role role) {
    scene.strokes.push_back({{from, to}, {role}});
}

void drawAxisUp(Scene& scene, const PlotFrame& plot, const Magnitude& magnitude, double scale) {
    const double step = tickStep(plot.high - plot.low, plot.frame.height, betweenTicksUp * scale);
    eachTick(plot.low, plot.high, step, [&](double value) {
        const double y = plot.at(plot.left, value).y;
        line(scene, {plot.frame.left, y}, {plot.frame.right(), y},
             value == 0 ? Role::plotZero : Role::plotAxis);
        const auto text = decimal(value / magnitude.unit, step / magnitude.unit);
        scene.labels.push_back(tickLabel(text, {plot.frame.left - 6 * scale, y}, 1));
    });
}

void drawAxisAcross(Scene& scene, const PlotFrame& plot, double scale) {
    const double step = tickStep(plot.right, plot.frame.width, betweenTicksAcross * scale);
    const double bottom = plot.frame.bottom();
    eachTick(0, plot.right, step, [&](double time) {
        const double x = plot.at(time, plot.low).x;
        line(scene, {x, bottom}, {x, bottom + tickLength * scale}, Role::plotAxis);
        const bool isLast = time + step > plot.right * (1 + 1e-9);
        scene.labels.push_back(tickLabel(decimal(time, std::min(step, 1.0)) + (isLast ? " s" : ""),
                                         {x, bottom + 12 * scale}, 0.5));
    });
}

void drawJoints(Scene& scene, const MotionPlot& plot, double scale) {
    const auto joints = plot.graph.joints();
    if (static_cast<double>(joints.size()) * betweenJoints * scale > plot.frame.frame.width) {
        return;
    }
    for (const double time : joints) {
        line(scene, plot.frame.at(time, plot.frame.low), plot.frame.at(time, plot.frame.high),
             Role::plotJoint);
    }
}

void drawBand(Scene& scene, const MotionPlot& plot) {
    const auto segment = plot.cursor.segment;
    const ScreenPoint start = plot.frame.at(plot.motion.timeAt({segment, 0}), plot.frame.high);
    const ScreenPoint end = plot.frame.at(plot.motion.timeAt({segment, 1}), plot.frame.low);
    scene.areas.push_back({{start.x, start.y, end.x - start.x, end.y - start.y}, {Role::plotBand}});
}

/// Draws the graph of one run, cut at the edges of the frame; each stretch beyond gets a triangle
/// where it goes farthest.
class GraphLine {
  public:
    GraphLine(Scene& scene, const PlotFrame& plot, double scale)
        : scene_(scene), plot_(plot), scale_(scale) {}
    GraphLine(const GraphLine&) = delete;
    GraphLine& operator=(const GraphLine&) = delete;
    ~GraphLine() {
        comeBack();
        lift();
    }

    void to(double time, double value) {
        const int side = value > plot_.high ? 1 : value < plot_.low ? -1 : 0;
        if (last_ && side != lastSide_) {
            cross(time, value, lastSide_);
            comeBack();
            cross(time, value, side);
        }
        if (side == 0) {
            points_.push_back(plot_.at(time, value));
        } else if (!beyond_ || std::abs(value) > std::abs(beyond_->value)) {
            beyond_ = Place{time, value};
        }
        last_ = Place{time, value};
        lastSide_ = side;
    }

    /// The line ends here; another may begin.
    void lift() {
        if (!points_.empty()) {
            scene_.strokes.push_back({std::move(points_), {Role::motion}});
            points_.clear();
        }
    }

  private:
    struct Place {
        double time, value;
    };

    /// A point on the edge between the last place and this one, if the line goes out of the frame
    /// or comes in at that side.
    void cross(double time, double value, int side) {
        if (side == 0) {
            return;
        }
        const double edge = side > 0 ? plot_.high : plot_.low;
        const double part = (edge - last_->value) / (value - last_->value);
        const double at = std::lerp(last_->time, time, std::clamp(part, 0.0, 1.0));
        const bool goesOut = lastSide_ != side;
        if (!goesOut) {
            lift();
        }
        points_.push_back(plot_.at(at, edge));
        if (goesOut) {
            lift();
        }
    }

    void comeBack() {
        if (!beyond_) {
            return;
        }
        const bool up = beyond_->value > 0;
        const double inset = (up ? pointerInset : -pointerInset) * scale_;
        const ScreenPoint edge = plot_.at(beyond_->time, up ? plot_.high : plot_.low);
        scene_.marks.push_back({{edge.x, edge.y + inset},
                                SignShape::triangle,
                                {Role::motion},
                                up ? 0 : std::numbers::pi,
                                withoutRim});
        beyond_.reset();
    }

    Scene& scene_;
    const PlotFrame& plot_;
    double scale_;
    std::vector<ScreenPoint> points_;
    std::optional<Place> last_, beyond_;
    int lastSide_ = 0;
};

void drawGraph(Scene& scene, const MotionPlot& plot, double scale) {
    for (const auto& run : plot.graph.runs()) {
        GraphLine graph(scene, plot.frame, scale);
        for (const auto& sample : run) {
            if (const auto value = valueOf(sample.moment, plot.quantity)) {
                graph.to(sample.time, *value);
            }
        }
    }
}

void drawCursorMarks(Scene& scene, const MotionPlot& plot) {
    const auto& frame = plot.frame;
    const double time = plot.motion.timeAt(plot.cursor);
    line(scene, frame.at(time, frame.low), frame.at(time, frame.high), Role::plotCursor);
    const auto value = valueOf(plot.motion.at(plot.cursor), plot.quantity);
    if (value && *value >= frame.low && *value <= frame.high) {
        scene.marks.push_back({frame.at(time, *value), SignShape::disc, {Role::motion}});
    }
}

std::string wordsAbove(const MotionPlot& plot, Caption caption, const Magnitude& magnitude) {
    const auto unit = magnitude.words + unitOf(plot.quantity);
    const auto name = nameOf(plot.quantity);
    if (caption == Caption::unit) {
        return name + ", " + unit;
    }
    return name + " at u = " + fixed(plot.cursor.u, 3) + ": " + valueAtCursor(plot) +
           (magnitude.words.empty() ? "" : " (axis in " + unit + ")");
}

} // namespace

std::optional<MotionPlot> motionPlot(const Study& study, const View& view,
                                     const ScreenRect& frame) {
    if (view.plot == Plot::basis) {
        return std::nullopt;
    }
    const auto quantity = view.plot == Plot::speed          ? Quantity::speed
                          : view.plot == Plot::acceleration ? Quantity::acceleration
                                                            : Quantity::curvature;
    const auto columns = static_cast<std::size_t>(std::clamp(frame.width, 1.0, 1e4));
    const auto& graph = study.motionGraph(view.pace, view.duration, columns);
    const auto& range = graph.range(quantity);
    const double spare = spareRange * (range.high - range.low);
    return MotionPlot{study,
                      study.motion(view.pace, view.duration),
                      graph,
                      quantity,
                      {frame, 0, view.duration, range.low - spare, range.high + spare},
                      view.cursor};
}

void drawMotion(Scene& scene, const MotionPlot& plot, Caption caption, double scale) {
    const auto& frame = plot.frame;
    drawBand(scene, plot);
    const auto magnitude = magnitudeOf(std::max(frame.high, -frame.low));
    drawAxisUp(scene, frame, magnitude, scale);
    drawAxisAcross(scene, frame, scale);
    drawJoints(scene, plot, scale);
    drawGraph(scene, plot, scale);
    drawCursorMarks(scene, plot);
    scene.labels.push_back(tickLabel(wordsAbove(plot, caption, magnitude),
                                     {frame.frame.left, frame.frame.top - 9 * scale}, 0));
}

std::string nameOf(Quantity quantity) {
    switch (quantity) {
    case Quantity::speed: return "speed";
    case Quantity::acceleration: return "acceleration";
    case Quantity::curvature: return "curvature";
    }
    return "";
}

std::string unitOf(Quantity quantity) {
    switch (quantity) {
    case Quantity::speed: return "units/s";
    case Quantity::acceleration: return "units/s²";
    case Quantity::curvature: return "1/unit";
    }
    return "";
}

std::string valueInWords(const MotionPlot& plot, double value) {
    constexpr double rounding = 1e-9; // of what the plot shows
    const auto& range = plot.graph.range(plot.quantity);
    const bool isNone =
        range.vanishes || std::abs(value) <= rounding * std::max(range.high, -range.low);
    return significant(isNone ? 0 : value, 4);
}

std::string valueAtCursor(const MotionPlot& plot) {
    const auto value = valueOf(plot.motion.at(plot.cursor), plot.quantity);
    return value ? valueInWords(plot, *value) + " " + unitOf(plot.quantity) : "undefined";
}

} // namespace splineloft::ui
