#include "ui/canvas/illustrate.h"

#include "core/document/edits.h"
#include "core/document/handles.h"
#include "ui/canvas/grid.h"
#include "ui/canvas/outline.h"
#include "ui/canvas/wording.h"

#include <algorithm>
#include <cmath>

namespace splineloft::ui {
namespace {

// More names than these on one curve are noise.
constexpr std::size_t mostNames = 60;
// A ladder of more levels is told by its lines; names for all its points would hide it.
constexpr int mostNamedLevels = 8;
constexpr std::size_t combTeeth = 150; // on the whole curve, about
constexpr double longestTooth = 90;    // design pixels
constexpr double usualTooth = 34;      // design pixels, for the mean curvature

constexpr double usualGap = 24; // design pixels between points whose marks have their full size
constexpr double leastGap = 4;  // design pixels between marks that can be told apart

/// One scene being drawn.
class Illustration {
  public:
    Illustration(const View& view, const Situation& situation)
        : view_(view), s_(situation), viewport_(situation.viewport), scale_(situation.scale),
          places_(situation.live, view.axes) {
        scene_.frame = viewport_.frame;
    }

    Scene take() { return std::move(scene_); }

    void otherCurves() {
        for (std::size_t i = 0; i < s_.studies.size(); ++i) {
            const Look& look = s_.live.curves[i].look;
            if (i == view_.activeCurve || !look.visible) {
                continue;
            }
            stroke(outline(s_.studies[i].plane(view_.axes), viewport_),
                   {Role::otherCurve, look.colour});
            for (const auto& place : controlPlaces(s_.studies[i].curve(), view_.axes)) {
                mark(place, shapeOf(s_.studies[i], 0), {Role::otherControl, look.colour});
            }
        }
    }

    void activeCurve(const Study& study) {
        const auto line = outline(study.plane(view_.axes), viewport_);
        if (view_.ghost) {
            stroke(line, {Role::curveHalo});
        }
        if (view_.layers.comb) {
            comb(study);
        }
        if (view_.layers.polygon) {
            polygon(study);
        }
        handles(study);
        stroke(line, {Role::curve, s_.live.curves[view_.activeCurve].look.colour});
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

    void joints(const Study& study) {
        for (const auto& joint : study.traits().joints) {
            if (joint.after < study.pieces().size()) {
                const Point p = study.plane(view_.axes).position({joint.after, 0});
                mark({p[0], p[1]}, SignShape::ring, {Role::joint});
            }
        }
    }

    void controls(const Study& study) {
        const auto places = controlPlaces(study.curve(), view_.axes);
        const double size = sizeOfMarks(places);
        std::optional<ScreenPoint> last;
        for (std::size_t i = 0; i < places.size(); ++i) {
            const ScreenPoint at = viewport_.toScreen(places[i]);
            if (size < 1 && last &&
                std::hypot(at.x - last->x, at.y - last->y) < leastGap * scale_) {
                continue; // too near to the one before to be told apart
            }
            last = at;
            const Role role = isHandle(study, i) ? Role::handle : Role::control;
            mark(places[i], shapeOf(study, i), {role, static_cast<int>(i)}, size);
            if (view_.layers.labels && places.size() <= mostNames && !isHandle(study, i)) {
                scene_.labels.push_back({pointName(i) + weightNote(study, i),
                                         viewport_.toScreen(places[i]),
                                         11 * scale_,
                                         {Role::control, static_cast<int>(i)},
                                         false});
            }
        }
    }

    void selection() {
        for (const auto& id : view_.selection) {
            if (id.curve < s_.live.curves.size()) {
                mark(placeOf(id), SignShape::ring, {Role::selected});
            }
        }
        if (view_.hovered && !view_.selection.contains(*view_.hovered) &&
            view_.hovered->curve < s_.live.curves.size()) {
            mark(placeOf(*view_.hovered), SignShape::ring, {Role::hovered});
        }
        if (view_.ghost && view_.activeCurve < s_.studies.size()) {
            const auto& plane = s_.studies[view_.activeCurve].plane(view_.axes);
            if (view_.ghost->segment < plane.size()) {
                const Point p = plane.position(*view_.ghost);
                mark({p[0], p[1]}, SignShape::disc, {Role::ghost});
            }
        }
    }

    void gesture(const Gesture& gesture) {
        if (const auto* box = std::get_if<Boxing>(&gesture)) {
            const auto r = spanned(box->from, box->now);
            scene_.strokes.push_back({{{r.left, r.top},
                                       {r.right(), r.top},
                                       {r.right(), r.bottom()},
                                       {r.left, r.bottom()}},
                                      {Role::box},
                                      true});
        }
        if (const auto* drag = std::get_if<DraggingPoints>(&gesture)) {
            course(*drag);
            if (drag->snappedTo) {
                mark(*drag->snappedTo, SignShape::diamond, {Role::snap});
            }
        } else if (const auto* pulling = std::get_if<Transforming>(&gesture);
                   pulling != nullptr && pulling->moved) {
            note(pulling->words, pulling->now);
        }
    }

    /// The frame around several selected points, while no hand is at work elsewhere.
    void gizmo(const Gesture& gesture) {
        const auto* pulling = std::get_if<Transforming>(&gesture);
        if (pulling == nullptr && !std::holds_alternative<Idle>(gesture)) {
            return;
        }
        const auto gizmo = gizmoOf(s_.live, view_, viewport_, scale_);
        if (!gizmo) {
            return;
        }
        const auto& f = gizmo->frame;
        stroke({gizmo->ring, gizmo->placeOf({0, 1})}, {Role::gizmo});
        scene_.strokes.push_back(
            {{{f.left, f.top}, {f.right(), f.top}, {f.right(), f.bottom()}, {f.left, f.bottom()}},
             {Role::gizmo},
             true});
        for (const auto& grip : gizmo->grips()) {
            const bool held =
                pulling != nullptr ? pulling->grip == grip : view_.hoveredGrip == grip;
            scene_.marks.push_back({gizmo->placeOf(grip),
                                    grip.turns() ? SignShape::disc : SignShape::square,
                                    {held ? Role::gripHeld : Role::grip}});
        }
    }

    void stems(const Gesture& gesture) {
        if (!std::holds_alternative<Idle>(gesture) &&
            !std::holds_alternative<SlidingStem>(gesture)) {
            return;
        }
        for (const auto& stem : stemsOf(s_.live, view_, viewport_, scale_)) {
            stroke({stem.from, stem.to}, {Role::stem});
            stroke({stem.from, stem.knob}, {Role::stemFilled});
            scene_.marks.push_back({stem.knob, SignShape::disc, {Role::gripHeld}});
            scene_.labels.push_back({.text = stem.words(),
                                     .at = stem.knob,
                                     .clearance = 12 * scale_,
                                     .ink = {Role::jointNote},
                                     .optional = false,
                                     .noted = true});
        }
    }

    /// The line that a drag keeps to.
    void course(const DraggingPoints& drag) {
        if (drag.course == Course::free) {
            return;
        }
        const ScreenPoint at = viewport_.toScreen(placeOf(drag.grabbed));
        const double far = viewport_.frame.width + viewport_.frame.height;
        const double dx = drag.course == Course::up ? 0 : far;
        const double dy = drag.course == Course::across    ? 0
                          : drag.course == Course::falling ? far
                                                           : -far;
        stroke({{at.x - dx, at.y - dy}, {at.x + dx, at.y + dy}}, {Role::course});
    }

    void note(const std::string& words, ScreenPoint at) {
        scene_.labels.push_back({.text = words,
                                 .at = at,
                                 .clearance = 20 * scale_,
                                 .ink = {Role::jointNote},
                                 .optional = false,
                                 .noted = true});
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

    /// Points that lie close together get small marks, so that the curve is still seen.
    double sizeOfMarks(const std::vector<PlanePoint>& places) const {
        if (places.size() <= mostNames) {
            return 1;
        }
        double way = 0;
        for (std::size_t i = 0; i + 1 < places.size(); ++i) {
            way += std::hypot(places[i + 1].x - places[i].x, places[i + 1].y - places[i].y);
        }
        const double apart =
            way * viewport_.camera.pixelsPerUnit / scale_ / static_cast<double>(places.size() - 1);
        return std::clamp(apart / usualGap, 0.3, 1.0);
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

    PlanePoint placeOf(const PointId& id) { return places_[id]; }

    void rungName(int r, std::size_t i, ScreenPoint at) {
        if (view_.layers.labels) {
            scene_.labels.push_back({"P_" + std::to_string(r) + "," + std::to_string(i),
                                     at,
                                     9 * scale_,
                                     {Role::ladder, r}});
        }
    }

    void polygon(const Study& study) {
        if (study.family().hasHandles) {
            return; // its handles tell the same
        }
        std::vector<ScreenPoint> line;
        for (const auto& place : controlPlaces(study.curve(), view_.axes)) {
            line.push_back(viewport_.toScreen(place));
        }
        if (line.size() > 1) {
            scene_.strokes.push_back({std::move(line), {Role::polygon}, study.curve().closed});
        }
    }

    void handles(const Study& study) {
        const Curve& curve = study.curve();
        const CurvePlaces places(curve, view_.axes);
        for (std::size_t i = 0; i < curve.points.size(); ++i) {
            if (const auto anchor = anchorOf(curve, i)) {
                stroke({viewport_.toScreen(places.point(*anchor)),
                        viewport_.toScreen(places.point(i))},
                       {Role::handleLine});
            }
        }
        for (std::size_t i = 0; i < curve.tangents.size(); ++i) {
            const ScreenPoint from = viewport_.toScreen(places.point(i));
            const ScreenPoint to = viewport_.toScreen(places.tangentTip(i));
            stroke({from, to}, {Role::handleLine});
            const double angle = std::atan2(to.y - from.y, to.x - from.x);
            scene_.marks.push_back(
                {to, SignShape::square, {Role::handle, static_cast<int>(i)}, angle});
        }
    }

    /// Teeth square to the curve, as long as the curvature; the mean has the usual length.
    void comb(const Study& study) {
        const auto& plane = study.plane(view_.axes);
        const int perPiece = static_cast<int>(
            std::clamp<std::size_t>(combTeeth / std::max<std::size_t>(plane.size(), 1), 6, 40));
        std::vector<Jet> jets;
        double sum = 0;
        for (std::size_t i = 0; i < plane.size(); ++i) {
            for (int k = 0; k <= perPiece; ++k) {
                jets.push_back(plane.jet({i, static_cast<double>(k) / perPiece}));
                sum += std::abs(jets.back().curvature.value_or(0));
            }
        }
        const double mean = jets.empty() ? 0 : sum / static_cast<double>(jets.size());
        std::vector<ScreenPoint> edge;
        for (const auto& jet : jets) {
            const ScreenPoint foot = viewport_.toScreen({jet.position[0], jet.position[1]});
            const double speed = norm(jet.first);
            if (!(mean > 0) || !(speed > 0)) {
                edge.push_back(foot);
                continue;
            }
            const double tooth = scale_ * std::clamp(usualTooth * *jet.curvature / mean,
                                                     -longestTooth, longestTooth);
            // To the outside of the bend; the screen's y points down.
            edge.push_back(
                {foot.x + tooth * jet.first[1] / speed, foot.y + tooth * jet.first[0] / speed});
            stroke({foot, edge.back()}, {Role::comb});
        }
        stroke(std::move(edge), {Role::combEdge});
    }

    const View& view_;
    const Situation& s_;
    const Viewport& viewport_;
    double scale_;
    PointPlaces places_;
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
        if (view.layers.joints) {
            drawing.joints(study);
        }
        drawing.ladder(study);
        drawing.controls(study);
    }
    drawing.selection();
    drawing.gizmo(gesture);
    drawing.stems(gesture);
    drawing.gesture(gesture);
    return drawing.take();
}

std::optional<std::size_t> jointNear(const Study& study, const View& view, const Viewport& viewport,
                                     ScreenPoint at, double reach) {
    const auto& joints = study.traits().joints;
    for (std::size_t i = 0; i < joints.size(); ++i) {
        if (joints[i].after >= study.pieces().size()) {
            continue;
        }
        const Point p = study.plane(view.axes).position({joints[i].after, 0});
        const ScreenPoint there = viewport.toScreen({p[0], p[1]});
        if (std::hypot(there.x - at.x, there.y - at.y) <= reach) {
            return i;
        }
    }
    return std::nullopt;
}

} // namespace splineloft::ui
