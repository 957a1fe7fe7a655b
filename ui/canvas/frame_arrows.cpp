#include "ui/canvas/frame_arrows.h"

#include "core/spline/measure/direction.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace splineloft::ui {
namespace {

// Lengths of arrows, design pixels.
constexpr double longest = 26;
constexpr double shortest = 10; // where beads are close together
constexpr double atCursor = 46;
constexpr double leastSeen = 4; // shorter ones point at the eye

constexpr double withoutRim = 0.99; // of a head's size: a rim would leave little of it

constexpr double partOfGap = 0.75; // between beads

/// Tangent and normals as they lie in the plane of the canvas.
struct FlatFrame {
    std::array<PlanePoint, 3> vectors;
    std::size_t count = 0;

    void add(PlanePoint vector) { vectors.at(count++) = vector; }
};

FlatFrame flatFrameAt(const Study& study, const Axes& axes, Spot spot) {
    FlatFrame flat;
    if (study.pieces().dimension() == 1) {
        if (const auto t = tangentAt(study.plane(axes)[spot.segment], spot.u)) {
            flat.add({(*t)[0], (*t)[1]});
            flat.add({-(*t)[1], (*t)[0]});
        }
        return flat;
    }
    const Frame frame = study.frames().at(spot);
    const auto add = [&](const Point& v) { flat.add({v[axes.across], v[axes.up]}); };
    add(frame.tangent);
    std::ranges::for_each(frame.normals, add);
    return flat;
}

class Arrows {
  public:
    Arrows(Scene& scene, const Study& study, const View& view, const Viewport& viewport,
           double scale)
        : scene_(scene), study_(study), view_(view), viewport_(viewport), scale_(scale) {}

    /// Those of one frame, so many design pixels long.
    void add(Spot spot, double length, bool clear) {
        const Point place = study_.plane(view_.axes).position(spot);
        const ScreenPoint from = viewport_.toScreen(PlanePoint{place[0], place[1]});
        const auto& f = viewport_.frame;
        const double edge = length * scale_;
        if (!(from.x > f.left - edge && from.x < f.right() + edge && from.y > f.top - edge &&
              from.y < f.bottom() + edge)) {
            return;
        }
        const auto frame = flatFrameAt(study_, view_.axes, spot);
        for (auto i = frame.count; i-- > 0;) { // the tangent on top
            const auto [x, y] = frame.vectors.at(i);
            arrow(from, {length * scale_ * x, -length * scale_ * y}, static_cast<int>(i), clear);
        }
    }

  private:
    void arrow(ScreenPoint from, ScreenPoint way, int which, bool clear) {
        if (std::hypot(way.x, way.y) < leastSeen * scale_) {
            return;
        }
        const ScreenPoint to{from.x + way.x, from.y + way.y};
        const Ink ink{clear ? Role::cursorFrame : Role::frame, which};
        scene_.strokes.push_back({{from, to}, ink});
        const double angle = std::atan2(way.x, -way.y);
        scene_.marks.push_back({to, SignShape::triangle, ink, angle, withoutRim});
    }

    Scene& scene_;
    const Study& study_;
    const View& view_;
    const Viewport& viewport_;
    double scale_;
};

} // namespace

void drawFrames(Scene& scene, const Study& study, const View& view, const Viewport& viewport,
                double scale) {
    if (study.pieces().empty()) {
        return;
    }
    const auto count = static_cast<std::size_t>(std::max(view.beads, 2));
    const double gap = study.inPlane(view.axes).points().way(study.curve().points.size()) *
                       viewport.camera.pixelsPerUnit / scale / static_cast<double>(count);
    const double length = std::clamp(partOfGap * gap, shortest, longest);
    Arrows arrows(scene, study, view, viewport, scale);
    for (const auto& spot : spread(study.pieces(), study.lengths(), view.pace, count)) {
        arrows.add(spot, length, false);
    }
    arrows.add(view.cursor, atCursor, true);
}

} // namespace splineloft::ui
