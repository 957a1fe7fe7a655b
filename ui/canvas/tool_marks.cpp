#include "ui/canvas/tool_marks.h"

#include "core/spline/catalog.h"
#include "ui/canvas/viewport.h"

namespace splineloft::ui {
namespace {

/// What the tools show, being drawn.
class ToolMarks {
  public:
    ToolMarks(Scene& scene, const View& view, const Situation& situation)
        : scene_(scene), view_(view), s_(situation), viewport_(situation.viewport),
          scale_(situation.scale) {}

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
            held(drag->held);
        } else if (const auto* placing = std::get_if<PlacingPoint>(&gesture)) {
            held(placing->held);
            handleToCome(*placing);
        } else if (const auto* pulling = std::get_if<Transforming>(&gesture);
                   pulling != nullptr && pulling->moved) {
            note(pulling->done.words, pulling->now);
        }
    }

    /// The frame around several selected points, while no hand is at work elsewhere.
    void gizmo(const Gesture& gesture) {
        const auto* pulling = std::get_if<Transforming>(&gesture);
        if (pulling == nullptr && !std::holds_alternative<Idle>(gesture)) {
            return;
        }
        // The ring takes the frame as it was along; grips have it follow the points.
        const bool turning = pulling != nullptr && pulling->grip.turns();
        const auto gizmo = turning ? gizmoAround(pulling->box, viewport_, scale_)
                                   : gizmoOf(s_.live, view_, viewport_, scale_);
        if (!gizmo) {
            return;
        }
        const auto moved = [&](ScreenPoint at) {
            if (!turning) {
                return at;
            }
            const PlanePoint before = viewport_.toPlane(at);
            const auto [x, y] = pulling->done.map.apply({before.x, before.y});
            return viewport_.toScreen(PlanePoint{x, y});
        };
        const auto& f = gizmo->frame;
        if (!f.contains(gizmo->ring)) {
            const int side = gizmo->ring.y < f.top ? 1 : -1;
            stroke({moved(gizmo->ring), moved(gizmo->placeOf({0, side}))}, {Role::gizmo});
        }
        scene_.strokes.push_back({{moved({f.left, f.top}), moved({f.right(), f.top}),
                                   moved({f.right(), f.bottom()}), moved({f.left, f.bottom()})},
                                  {Role::gizmo},
                                  true});
        for (const auto& grip : gizmo->grips()) {
            const bool held =
                pulling != nullptr ? pulling->grip == grip : view_.hoveredGrip == grip;
            scene_.marks.push_back({moved(gizmo->placeOf(grip)),
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

  private:
    /// The line that a hand keeps to, and what it snapped to.
    void held(const Held& held) {
        if (held.course != Course::free) {
            const ScreenPoint at = viewport_.toScreen(held.through);
            const double far = viewport_.frame.width + viewport_.frame.height;
            const double dx = held.course == Course::up ? 0 : far;
            const double dy = held.course == Course::across    ? 0
                              : held.course == Course::falling ? far
                                                               : -far;
            stroke({{at.x - dx, at.y - dy}, {at.x + dx, at.y + dy}}, {Role::course});
        }
        if (held.to) {
            scene_.marks.push_back(
                {viewport_.toScreen(*held.to), SignShape::diamond, {Role::snap}});
        }
    }

    /// The handle that the pen pulls out of an anchor: a point of the curve only when the next
    /// anchor comes. It lies opposite to the one before the anchor.
    void handleToCome(const PlacingPoint& placing) {
        const auto [curve, index, part] = placing.point;
        const bool isThere = curve < s_.live.curves.size() && // not where it was refused
                             index < s_.live.curves[curve]->points.size();
        if (!isThere || index == 0 || !familyOf(*s_.live.curves[curve]).hasHandles) {
            return;
        }
        const PointId before{curve, index - 1, Part::point};
        PointPlaces places(s_.live, view_.axes);
        const PlanePoint handle = places[before];
        if (handle == PointPlaces(placing.placed, view_.axes)[before]) {
            return; // not pulled yet
        }
        const PlanePoint anchor = places[placing.point];
        const ScreenPoint from = viewport_.toScreen(anchor);
        const ScreenPoint to =
            viewport_.toScreen({2 * anchor.x - handle.x, 2 * anchor.y - handle.y});
        stroke({from, to}, {Role::handleLine});
        scene_.marks.push_back(
            {to, SignShape::square, {Role::handle, static_cast<int>(index + 1)}});
    }

    void note(const std::string& words, ScreenPoint at) {
        scene_.labels.push_back({.text = words,
                                 .at = at,
                                 .clearance = 20 * scale_,
                                 .ink = {Role::jointNote},
                                 .optional = false,
                                 .noted = true});
    }

    void stroke(std::vector<ScreenPoint> points, Ink ink) {
        scene_.strokes.push_back({std::move(points), ink});
    }

    Scene& scene_;
    const View& view_;
    const Situation& s_;
    const Viewport& viewport_;
    double scale_;
};

} // namespace

void drawToolMarks(Scene& scene, const View& view, const Gesture& gesture,
                   const Situation& situation) {
    ToolMarks marks(scene, view, situation);
    marks.gizmo(gesture);
    marks.stems(gesture);
    marks.gesture(gesture);
}

} // namespace splineloft::ui
