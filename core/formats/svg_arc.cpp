#include "core/formats/svg_arc.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace splineloft {
namespace {

constexpr double pi = std::numbers::pi;
// An arc whose chord is this part of its radius strays from it by an eighth of that, which no
// coordinate shows.
constexpr double flat = 1e-9;

/// An arc as its ellipse gives it (F.6.5).
struct Ellipse {
    PlaneMap fromUnitCircle;
    double startAngle = 0;
    double turn = 0; ///< signed
};

Ellipse ellipseOf(const SvgArc& arc) {
    const double angle = arc.rotation * pi / 180;
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    // Half of the way back from the end to the start, along the ellipse's axes.
    const double halfX = (arc.start.x - arc.end.x) / 2;
    const double halfY = (arc.start.y - arc.end.y) / 2;
    const double x = c * halfX + s * halfY;
    const double y = -s * halfX + c * halfY;
    double rx = std::abs(arc.radiusX);
    double ry = std::abs(arc.radiusY);
    const double stretch = std::hypot(x / rx, y / ry); // above 1 where the radii are too small
    rx *= std::max(stretch, 1.0);
    ry *= std::max(stretch, 1.0);
    // In units of the radii, the middle between the ends lies `stretch` from each.
    const double reach = std::min(stretch, 1.0);
    const double away = std::sqrt(std::max(0.0, 1 - reach * reach)) / reach;
    const double side = arc.isLarge == arc.sweeps ? -away : away;
    const double centerX = side * y / ry; // still of a unit circle
    const double centerY = -side * x / rx;
    const double startAngle = std::atan2(y / ry - centerY, x / rx - centerX);
    double turn = std::atan2(-y / ry - centerY, -x / rx - centerX) - startAngle;
    if (arc.sweeps && turn < 0) {
        turn += 2 * pi;
    } else if (!arc.sweeps && turn > 0) {
        turn -= 2 * pi;
    }
    PlaneMap map{c * rx, -s * ry, s * rx, c * ry, 0, 0};
    const PlanePlace center = map.applyLinear({centerX, centerY});
    map.dx = center.x + (arc.start.x + arc.end.x) / 2;
    map.dy = center.y + (arc.start.y + arc.end.y) / 2;
    return {map, startAngle, turn};
}

} // namespace

std::vector<CubicTo> cubicsOf(const SvgArc& arc) {
    if (arc.start == arc.end) {
        return {};
    }
    const double chord = std::hypot(arc.end.x - arc.start.x, arc.end.y - arc.start.y);
    if (chord < flat * std::min(std::abs(arc.radiusX), std::abs(arc.radiusY)) && !arc.isLarge) {
        const auto at = [&](double part) {
            return PlanePlace{std::lerp(arc.start.x, arc.end.x, part),
                              std::lerp(arc.start.y, arc.end.y, part)};
        };
        return {{at(1.0 / 3), at(2.0 / 3), arc.end}};
    }
    const auto [map, startAngle, turn] = ellipseOf(arc);
    const auto quarters = std::max(1.0, std::ceil(std::abs(turn) / (pi / 2) - 1e-9));
    const double step = turn / quarters;
    const double reach = 4.0 / 3 * std::tan(step / 4);
    std::vector<CubicTo> cubics;
    for (double k = 0; k < quarters; ++k) {
        const double from = startAngle + k * step;
        const double to = from + step;
        const PlanePlace a{std::cos(from), std::sin(from)};
        const PlanePlace b{std::cos(to), std::sin(to)};
        cubics.push_back({map.apply({a.x - reach * a.y, a.y + reach * a.x}),
                          map.apply({b.x + reach * b.y, b.y - reach * b.x}), map.apply(b)});
    }
    cubics.back()[2] = arc.end;
    return cubics;
}

} // namespace splineloft
