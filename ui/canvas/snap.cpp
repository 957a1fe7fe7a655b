#include "ui/canvas/snap.h"

#include "ui/canvas/grid.h"

#include <algorithm>
#include <cmath>

namespace splineloft::ui {
namespace {

// How near another point must be to be snapped to, design pixels.
constexpr double snapReach = 9;

PlanePoint startOf(const PointId& id, const View& view, const Situation& s) {
    const Curve& curve = *s.settled.curves[id.curve];
    return id.part == Part::tangent ? tangentTip(curve, view.axes, id.index)
                                    : controlPlaces(curve, view.axes)[id.index];
}

std::optional<PlanePoint> nearbyPoint(PlanePoint wanted, const std::vector<PointId>& ids,
                                      const View& view, const Situation& s) {
    std::optional<PlanePoint> found;
    double best = s.viewport.toPlane(snapReach * s.scale);
    for (std::size_t c = 0; c < s.settled.curves.size(); ++c) {
        const auto places = controlPlaces(*s.settled.curves[c], view.axes);
        for (std::size_t i = 0; i < places.size(); ++i) {
            const double away = std::hypot(places[i].x - wanted.x, places[i].y - wanted.y);
            if (away < best && std::ranges::find(ids, PointId{c, i, Part::point}) == ids.end()) {
                best = away;
                found = places[i];
            }
        }
    }
    return found;
}

/// From `start` to `place`; a move along one axis only (Shift) stays on it.
SnappedMove moveTo(PlanePoint place, PlanePoint start, const SnappedMove& move,
                   std::optional<PlanePoint> cue) {
    return {move.dx == 0 ? 0 : place.x - start.x, move.dy == 0 ? 0 : place.y - start.y, cue};
}

} // namespace

SnappedMove snapped(const SnappedMove& move, const std::vector<PointId>& ids,
                    const PointId& grabbed, const View& view, const Situation& situation) {
    const PlanePoint start = startOf(grabbed, view, situation);
    const PlanePoint wanted{start.x + move.dx, start.y + move.dy};
    auto to = nearbyPoint(wanted, ids, view, situation);
    if (!to) {
        const double step = fineGridStep(situation.viewport.camera, situation.scale);
        to = PlanePoint{roundedTo(wanted.x, step), roundedTo(wanted.y, step)};
    }
    return moveTo(*to, start, move, to);
}

PlanePoint tidied(PlanePoint place, const Camera& camera) {
    const double step = std::pow(10.0, std::floor(-std::log10(camera.pixelsPerUnit)));
    return {roundedTo(place.x, step), roundedTo(place.y, step)};
}

SnappedMove tidied(const SnappedMove& move, const PointId& grabbed, const View& view,
                   const Situation& situation) {
    const PlanePoint start = startOf(grabbed, view, situation);
    const PlanePoint wanted{start.x + move.dx, start.y + move.dy};
    return moveTo(tidied(wanted, situation.viewport.camera), start, move, std::nullopt);
}

} // namespace splineloft::ui
