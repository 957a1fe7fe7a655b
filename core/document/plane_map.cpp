#include "core/document/plane_map.h"

#include <cmath>

namespace splineloft {
namespace {

/// The linear part of a map, with the displacement that leaves `center` where it is.
PlaneMap about(PlanePlace center, PlaneMap map) {
    const PlanePlace image = map.applyLinear(center);
    map.dx = center.x - image.x;
    map.dy = center.y - image.y;
    return map;
}

} // namespace

PlaneMap PlaneMap::moved(double dx, double dy) {
    return {1, 0, 0, 1, dx, dy};
}

PlaneMap PlaneMap::scaledAbout(PlanePlace center, double byX, double byY) {
    return about(center, {byX, 0, 0, byY, 0, 0});
}

PlaneMap PlaneMap::rotatedAbout(PlanePlace center, double angle) {
    // So that quarter turns leave no dust.
    const auto whole = [](double part) { return std::abs(part) < 1e-15 ? 0 : part; };
    const double c = whole(std::cos(angle));
    const double s = whole(std::sin(angle));
    return about(center, {c, -s, s, c, 0, 0});
}

PlanePlace PlaneMap::apply(PlanePlace place) const {
    const PlanePlace image = applyLinear(place);
    return {image.x + dx, image.y + dy};
}

PlanePlace PlaneMap::applyLinear(PlanePlace difference) const {
    return {xx * difference.x + xy * difference.y, yx * difference.x + yy * difference.y};
}

PlaneMap composed(const PlaneMap& second, const PlaneMap& first) {
    const PlanePlace across = second.applyLinear({first.xx, first.yx});
    const PlanePlace up = second.applyLinear({first.xy, first.yy});
    const PlanePlace origin = second.apply({first.dx, first.dy});
    return {across.x, up.x, across.y, up.y, origin.x, origin.y};
}

} // namespace splineloft
