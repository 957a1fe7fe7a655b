#include "ui/canvas/illustrate.h"

#include "core/document/edits.h"
#include "ui/canvas/comb.h"
#include "ui/canvas/frame_arrows.h"
#include "ui/canvas/grid.h"
#include "ui/canvas/line_work.h"
#include "ui/canvas/tool_marks.h"
#include "ui/canvas/wording.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace splineloft::ui {
namespace {

// More names than these on one curve are noise.
constexpr std::size_t mostNames = 60;
// A ladder of more levels is told by its lines; names for all its points would hide it.
constexpr int mostNamedLevels = 8;

// More than these in view are thinned out.
constexpr std::size_t mostMarks = 3000;

constexpr double usualGap = 24; // design pixels between points whose marks have their full size
constexpr double leastGap = 4;  // design pixels between marks that can be told apart

/// Keeps marks in a row so far apart that they can be told apart.
class Spacing {
  public:
    explicit Spacing(double least) : least_(least) {} // pixels

    bool leavesRoomFor(ScreenPoint at) {
        const double dx = at.x - last_.x;
        const double dy = at.y - last_.y;
        if (dx * dx + dy * dy < least_ * least_) {
            return false;
        }
        last_ = at;
        return true;
    }

  private:
    double least_;
    ScreenPoint last_{std::numeric_limits<double>::infinity(), 0}; // none yet
};

/// One scene being drawn.
class Illustration {
  public:
    Illustration(const View& view, const Situation& situation)
        : view_(view), s_(situation), viewport_(situation.viewport), scale_(situation.scale) {
        scene_.frame = viewport_.frame;
    }

    Scene take() { return std::move(scene_); }

    void otherCurves() {
        for (std::size_t i = 0; i < s_.studies.size(); ++i) {
            const Look& look = s_.live.curves[i].look;
            if (i == view_.activeCurve || !look.visible) {
                continue;
            }
            const Study& study = s_.studies[i];
            curve(study, {Role::otherCurve, look.colour});
            const auto& points = study.inPlane(view_.axes).points();
            const SignShape shape = shapeOf(study, 0);
            forEachMark(points, 1, [&](std::size_t, PlanePoint place) {
                mark(place, shape, {Role::otherControl, look.colour});
            });
        }
    }

    void activeCurve(const Study& study) {
        if (view_.ghost && view_.ghost->curve == view_.activeCurve) {
            curve(study, {Role::curveHalo});
        }
        if (view_.layers.comb) {
            drawComb(scene_, study, view_.axes, viewport_, scale_);
        }
        if (view_.layers.polygon && !study.family().hasHandles) { // handles tell the same
            drawPolygon(scene_, study.inPlane(view_.axes), study.curve().closed, {Role::polygon},
                        viewport_);
        }
        if (study.family().hasHandles) {
            drawHandles(scene_, study.inPlane(view_.axes), study.curve(), {Role::handleLine},
                        viewport_);
        }
        tangents(study);
        curve(study, {Role::curve, s_.live.curves[view_.activeCurve].look.colour});
    }

    void ladder(const Study& study) {
        const auto& plane = study.plane(view_.axes);
        if (plane.empty()) {
            return;
        }
        const auto ladder = plane[view_.cursor.segment].ladder(view_.cursor.u);
        for (int r = 0; view_.layers.ladder && r < ladder.degree(); ++r) {
            std::vector<ScreenPoint> line;
            for (const auto& p : ladder.level(r)) {
                line.push_back(viewport_.toScreen({p[0], p[1]}));
            }
            if (line.size() > 1) {
                stroke(line, {Role::ladder, r});
            }
            for (std::size_t i = 0; i < line.size(); ++i) {
                scene_.marks.push_back(
                    {line[i], r == 0 ? SignShape::square : SignShape::disc, {Role::ladder, r}});
                if (ladder.degree() <= mostNamedLevels) {
                    rungName(r, i, line[i]);
                }
            }
        }
        const Point& tip = ladder.tip();
        const ScreenPoint at = viewport_.toScreen({tip[0], tip[1]});
        scene_.marks.push_back({at, SignShape::disc, {Role::tip}});
        if (view_.layers.ladder && view_.layers.labels) {
            scene_.labels.push_back({"u = " + fixed(view_.cursor.u, 3),
                                     at,
                                     13 * scale_,
                                     {Role::tip},
                                     true,
                                     false,
                                     true});
        }
    }

    void beads(const Study& study) {
        const auto count = static_cast<std::size_t>(std::max(view_.beads, 2));
        const auto& plane = study.plane(view_.axes);
        for (const auto& spot : spread(study.pieces(), study.lengths(), view_.pace, count)) {
            const Point p = plane.position(spot);
            mark({p[0], p[1]}, SignShape::disc, {Role::bead});
        }
    }

    void frames(const Study& study) { drawFrames(scene_, study, view_, viewport_, scale_); }

    void joints(const Study& study) {
        for (const auto& joint : study.traits().joints) {
            if (joint.after < study.pieces().size()) {
                mark(startOf(study, joint.after), SignShape::ring, {Role::joint});
            }
        }
    }

    void controls(const Study& study) {
        const auto& points = study.inPlane(view_.axes).points();
        const auto count = points.places().size();
        const double size = sizeOfMarks(points);
        forEachMark(points, size, [&](std::size_t i, PlanePoint place) {
            const Role role = isHandle(study, i) ? Role::handle : Role::control;
            mark(place, shapeOf(study, i), {role, static_cast<int>(i)}, size);
            if (view_.layers.labels && count <= mostNames && !isHandle(study, i)) {
                scene_.labels.push_back({pointName(i) + weightNote(study, i),
                                         viewport_.toScreen(place),
                                         11 * scale_,
                                         {Role::control, static_cast<int>(i)},
                                         false});
            }
        });
    }

    void selection() {
        Spacing spacing(view_.selection.size() > mostNames ? leastGap * scale_ : 0);
        const bool few = view_.selection.size() <= mostNames;
        for (const auto& id : view_.selection) {
            if (few && id.curve == view_.activeCurve && id.part == Part::point) {
                raised(id);
            }
            if (id.curve < s_.live.curves.size() &&
                spacing.leavesRoomFor(viewport_.toScreen(placeOf(s_.studies, view_.axes, id)))) {
                mark(placeOf(s_.studies, view_.axes, id), SignShape::ring, {Role::selected});
            }
        }
        if (view_.hovered && !view_.selection.contains(*view_.hovered) &&
            view_.hovered->curve < s_.live.curves.size()) {
            mark(placeOf(s_.studies, view_.axes, *view_.hovered), SignShape::ring, {Role::hovered});
        }
        if (view_.ghost && view_.ghost->curve < s_.studies.size()) {
            const auto& plane = s_.studies[view_.ghost->curve].plane(view_.axes);
            if (view_.ghost->spot.segment < plane.size()) {
                const Point p = plane.position(view_.ghost->spot);
                mark({p[0], p[1]}, SignShape::disc, {Role::ghost});
            }
        }
    }

    void grid() {
        if (view_.layers.grid) {
            drawGrid(scene_, viewport_, scale_);
        }
        if (view_.layers.gridNumbers) {
            drawGridNumbers(scene_, viewport_, scale_);
        }
    }

  private:
    void stroke(std::vector<ScreenPoint> points, Ink ink) {
        if (!points.empty()) {
            scene_.strokes.push_back({std::move(points), ink});
        }
    }

    void curve(const Study& study, Ink ink) {
        drawCurve(scene_, study.inPlane(view_.axes), study.curve().closed, ink, viewport_);
    }

    /// Points that lie close together get small marks, so that the curve is still seen.
    double sizeOfMarks(const PlacedPoints& points) const {
        const auto count = points.places().size();
        if (count <= mostNames) {
            return 1;
        }
        const double apart = points.way(count) * viewport_.camera.pixelsPerUnit / scale_ /
                             static_cast<double>(count - 1);
        return std::clamp(apart / usualGap, 0.3, 1.0);
    }

    /// Calls `use(index, place)` for the points that get a mark: small ones only where they can be
    /// told apart, and of very many in view every second, fourth ...
    template <class Use> void forEachMark(const PlacedPoints& points, double size, Use use) const {
        const auto places = points.places();
        const auto [ranges, step] = samplingOf(points.boxes(), mostMarks, viewport_);
        Spacing spacing(size < 1 || step > 1 ? leastGap * scale_ : 0);
        for (const auto& range : ranges) {
            for (auto i = (range.first + step - 1) / step * step; i < range.last; i += step) {
                if (spacing.leavesRoomFor(viewport_.toScreen(places[i]))) {
                    use(i, places[i]);
                }
            }
        }
    }

    /// Where a piece begins.
    PlanePoint startOf(const Study& study, std::size_t piece) const {
        const Point p = study.plane(view_.axes)[piece].bezierPoint(0);
        return {p[0], p[1]};
    }

    void mark(PlanePoint place, SignShape shape, Ink ink, double size = 1) {
        const ScreenPoint at = viewport_.toScreen(place);
        const auto& f = viewport_.frame;
        const double edge = 20 * scale_;
        if (at.x > f.left - edge && at.x < f.right() + edge && at.y > f.top - edge &&
            at.y < f.bottom() + edge) {
            scene_.marks.push_back({at, shape, ink, 0, size});
        }
    }

    /// A control point of the active curve once more, above others that lie on it.
    void raised(const PointId& id) {
        const Study& study = s_.studies[id.curve];
        const auto& points = study.inPlane(view_.axes).points();
        const Role role = isHandle(study, id.index) ? Role::handle : Role::control;
        mark(points.places()[id.index], shapeOf(study, id.index),
             {role, static_cast<int>(id.index)}, sizeOfMarks(points));
    }

    /// The weight of a point under the pointer or selected, where the curve has weights.
    std::string weightNote(const Study& study, std::size_t i) const {
        const auto& weights = study.curve().weights;
        const PointId id{view_.activeCurve, i, Part::point};
        const bool wanted = view_.hovered == id || view_.selection.contains(id);
        return weights.empty() || !wanted ? "" : " · w " + significant(weights[i], 4);
    }

    static bool isHandle(const Study& study, std::size_t i) {
        return study.family().hasHandles && i % 3 != 0;
    }

    /// On the curve a disc, off it a diamond, handles a square: shape before colour.
    static SignShape shapeOf(const Study& study, std::size_t i) {
        return isHandle(study, i)   ? SignShape::square
               : study.isOnCurve(i) ? SignShape::disc
                                    : SignShape::diamond;
    }

    void rungName(int r, std::size_t i, ScreenPoint at) {
        if (view_.layers.labels) {
            scene_.labels.push_back({"P_" + std::to_string(r) + "," + std::to_string(i),
                                     at,
                                     9 * scale_,
                                     {Role::ladder, r}});
        }
    }

    void tangents(const Study& study) {
        const PlaneStudy& plane = study.inPlane(view_.axes);
        forEachMark(plane.tips(), 1, [&](std::size_t i, PlanePoint tip) {
            const ScreenPoint from = viewport_.toScreen(plane.points().places()[i]);
            const ScreenPoint to = viewport_.toScreen(tip);
            stroke({from, to}, {Role::handleLine});
            const double angle = std::atan2(to.y - from.y, to.x - from.x);
            scene_.marks.push_back(
                {to, SignShape::square, {Role::handle, static_cast<int>(i)}, angle});
        });
    }

    const View& view_;
    const Situation& s_;
    const Viewport& viewport_;
    double scale_;
    Scene scene_;
};

} // namespace

Scene illustrate(const View& view, const Gesture& gesture, const Situation& situation) {
    Illustration drawing(view, situation);
    drawing.grid();
    drawing.otherCurves();
    if (view.activeCurve < situation.studies.size() &&
        situation.live.curves[view.activeCurve].look.visible) {
        const Study& study = situation.studies[view.activeCurve];
        drawing.activeCurve(study);
        if (view.layers.beads) {
            drawing.beads(study);
        }
        if (view.layers.frames) {
            drawing.frames(study);
        }
        if (view.layers.joints) {
            drawing.joints(study);
        }
        drawing.ladder(study);
        drawing.controls(study);
    }
    drawing.selection();
    Scene scene = drawing.take();
    drawToolMarks(scene, view, gesture, situation);
    return scene;
}

std::optional<std::size_t> jointNear(const Study& study, const View& view, const Viewport& viewport,
                                     ScreenPoint at, double reach) {
    const auto& joints = study.traits().joints;
    if (joints.empty()) {
        return std::nullopt;
    }
    const PlaneStudy& plane = study.inPlane(view.axes);
    std::optional<std::size_t> near;
    const PlaneBounds box = around(viewport.toPlane(at), viewport.toPlane(reach));
    plane.boxes().touching(box, [&](std::size_t block) {
        const Range pieces = plane.boxes().block(block);
        for (auto i = pieces.first; i < pieces.last && !near; ++i) {
            // The joint at the start of piece i comes after i - 1, that of a loop after the last.
            const auto joint = (i + plane.pieces().size() - 1) % plane.pieces().size();
            const Point p = plane.pieces()[i].bezierPoint(0);
            const ScreenPoint there = viewport.toScreen(PlanePoint{p[0], p[1]});
            if (joint < joints.size() && std::hypot(there.x - at.x, there.y - at.y) <= reach) {
                near = joint;
            }
        }
    });
    return near;
}

} // namespace splineloft::ui
