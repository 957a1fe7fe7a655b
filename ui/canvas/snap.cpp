#include "ui/canvas/snap.h"

#include "ui/canvas/grid.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace splineloft::ui {
namespace {

// How near another point must be to be snapped to, design pixels.
constexpr double snapReach = 9;

/// The control point nearest to a place, of those that stay where they are.
std::optional<PlanePoint> nearbyPoint(PlanePoint wanted, const std::vector<PointId>& ids,
                                      const View& view, const Situation& s) {
    const auto stays = [&](const PointId& id) {
        return id.index < s.settled.curves[id.curve]->points.size() &&
               std::ranges::equal(s.settled.curves[id.curve]->points[id.index],
                                  s.live.curves[id.curve]->points[id.index]) &&
               std::ranges::find(ids, id) == ids.end();
    };
    std::optional<PlanePoint> found;
    double best = s.viewport.toPlane(snapReach * s.scale);
    for (std::size_t c = 0; c < std::min(s.studies.size(), s.settled.curves.size()); ++c) {
        if (!s.settled.curves[c].look.visible) {
            continue;
        }
        s.studies[c].inPlane(view.axes).points().forEachNear(
            around(wanted, best), [&](std::size_t i, PlanePoint place) {
                const double away = std::hypot(place.x - wanted.x, place.y - wanted.y);
                if (away < best && stays({c, i, Part::point})) {
                    best = away;
                    found = place;
                }
            });
    }
    return found;
}

/// From `start` to `place`, as far as the move's course allows; a coordinate that did not move
/// stays as it is.
SnappedMove moveTo(PlanePoint place, PlanePoint start, const SnappedMove& move,
                   std::optional<PlanePoint> cue) {
    const double dx = move.dx == 0 ? 0 : place.x - start.x;
    const double dy = move.dy == 0 ? 0 : place.y - start.y;
    switch (move.course) {
    case Course::rising: return {dx, dx, move.course, cue};
    case Course::falling: return {dx, -dx, move.course, cue};
    default: return {dx, dy, move.course, cue};
    }
}

} // namespace

SnappedMove onCourse(double dx, double dy) {
    const double turns = std::atan2(dy, dx) / (std::numbers::pi / 4);
    switch ((static_cast<int>(std::lround(turns)) + 8) % 4) {
    case 0: return {dx, 0, Course::across};
    case 1: return {0.5 * (dx + dy), 0.5 * (dx + dy), Course::rising};
    case 2: return {0, dy, Course::up};
    default: return {0.5 * (dx - dy), 0.5 * (dy - dx), Course::falling};
    }
}

PlanePoint tidied(PlanePoint place, const Camera& camera) {
    const double step = std::pow(10.0, std::floor(-std::log10(camera.pixelsPerUnit)));
    return {roundedTo(place.x, step), roundedTo(place.y, step)};
}

SnappedMove steered(double dx, double dy, PlanePoint start, const Modifiers& modifiers,
                    const std::vector<PointId>& ids, const View& view, const Situation& situation) {
    const SnappedMove move = modifiers.shift ? onCourse(dx, dy) : SnappedMove{dx, dy};
    const PlanePoint wanted = move.from(start);
    const Camera& camera = situation.viewport.camera;
    if (!modifiers.control) {
        return moveTo(tidied(wanted, camera), start, move, std::nullopt);
    }
    auto to = nearbyPoint(wanted, ids, view, situation);
    if (!to) {
        const double step = fineGridStep(camera, situation.scale);
        to = PlanePoint{roundedTo(wanted.x, step), roundedTo(wanted.y, step)};
    }
    return moveTo(*to, start, move, to);
}

} // namespace splineloft::ui
