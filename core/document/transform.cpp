// A selection moved, turned and scaled in the plane.
#include "core/document/change.h"
#include "core/document/edits.h"
#include "core/document/tidy.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace splineloft {
namespace {

/// A map of the plane, and the coordinates of a curve that it maps.
class Mapping {
  public:
    Mapping(const PlaneMap& map, int across, int up, int dimension)
        : map_(map), across_(std::min(across, dimension - 1)), up_(std::min(up, dimension - 1)) {}

    Point place(Point place) const { return mapped(std::move(place), map_); }
    Point tangent(Point tangent) const {
        PlaneMap linear = map_;
        linear.dx = linear.dy = 0;
        return mapped(std::move(tangent), linear);
    }

  private:
    Point mapped(Point point, const PlaneMap& map) const {
        if (across_ == up_) {
            const double image = map.yy * point[up_] + map.dy;
            set(point[up_], map.yx == 0 ? image : point[up_]);
            return point;
        }
        const PlanePlace image = map.apply({point[across_], point[up_]});
        set(point[across_], image.x);
        set(point[up_], image.y);
        return point;
    }
    static void set(double& coordinate, double value) {
        if (coordinate != value) {
            coordinate = tidied(value);
        }
    }

    PlaneMap map_;
    int across_, up_;
};

void transformPointsOf(Curve& curve, HandleModes& modes, const std::vector<PointId>& ids,
                       const Mapping& mapping) {
    const Curve before = curve;
    const auto moved = withTheirHandles(curve, ids);
    for (const auto index : moved) {
        curve.points.set(index, mapping.place(before.points.at(index)));
    }
    for (const auto& id : ids) {
        if (!curve.tangents.empty()) {
            curve.tangents.set(id.index, mapping.tangent(before.tangents.at(id.index)));
        }
    }
    keepPartners(before, curve, modes, moved);
}

} // namespace

Document transformPoints(const Document& document, std::span<const PointId> ids,
                         const PlaneMap& map, int across, int up) {
    Document next = document;
    for (std::size_t i = 0; i < document.curves.size(); ++i) {
        std::vector<PointId> own;
        std::ranges::copy_if(ids, std::back_inserter(own),
                             [i](const PointId& id) { return id.curve == i; });
        if (own.empty()) {
            continue;
        }
        next = changed(next, i, [&](Curve& curve, HandleModes& modes) {
            transformPointsOf(curve, modes, own, {map, across, up, curve.points.dimension()});
        });
    }
    return next;
}

} // namespace splineloft
