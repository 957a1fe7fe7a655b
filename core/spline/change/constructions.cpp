#include "core/spline/change/constructions.h"

#include "core/spline/arrangement.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace splineloft {
namespace {

/// What keeps the curve from having the construction of these families.
std::optional<Problem> refusal(const Curve& curve, std::initializer_list<std::string_view> families,
                               const std::string& name) {
    if (auto problem = problemOf(curve)) {
        return problem;
    }
    if (std::ranges::find(families, std::string_view(curve.family)) == families.end()) {
        std::string choice;
        for (const auto family : families) {
            choice += (choice.empty() ? "" : " or ") + std::string(family);
        }
        return Problem{"/family", "the family " + curve.family + " has no " + name, choice};
    }
    if (arrangementOf(curve, curve.points).pieces() == 0) {
        return Problem{"/points", "has too few points for a piece",
                       std::to_string(fewestPoints(curve)) + " points or more"};
    }
    return std::nullopt;
}

/// The places in a window of the arrangement.
std::vector<Point> placesOf(const Curve& curve, const Arrangement& arrangement,
                            std::size_t window) {
    std::vector<Point> points;
    for (int k = 0; k < arrangement.layout.window; ++k) {
        const Place& place = arrangement.places[window + static_cast<std::size_t>(k)];
        const Point own = curve.points.at(place.control);
        points.push_back(place.mirroredAt ? 2.0 * curve.points.at(*place.mirroredAt) - own : own);
    }
    return points;
}

/// A place times its weight, followed by it.
Point weighted(const Point& place, double weight) {
    Point point(place.dimension() + 1);
    for (int c = 0; c < place.dimension(); ++c) {
        point[c] = weight * place[c];
    }
    point[place.dimension()] = weight;
    return point;
}

void project(Construction& construction) {
    for (auto& level : construction.levels) {
        for (auto& rung : level) {
            const int last = rung.place.dimension() - 1;
            const auto numerators = rung.place.coordinates().first(static_cast<std::size_t>(last));
            rung.place = (1 / rung.place[last]) * Point(numerators);
        }
    }
}

} // namespace

std::variant<Construction, Problem> deBoor(const Curve& curve, double t) {
    if (auto problem = refusal(curve, {"b-spline", "nurbs"}, "triangle of de Boor")) {
        return *problem;
    }
    const auto arrangement = arrangementOf(curve, curve.points);
    const auto segment = arrangement.joints.locate(t).segment;
    const auto window = arrangement.windows[segment];
    const auto degree = static_cast<std::size_t>(arrangement.layout.degree);
    const auto knots = std::span(arrangement.knots).subspan(window, 2 * degree + 2);
    const double inside = t > knots[degree] ? std::min(t, knots[degree + 1]) : knots[degree];
    const auto points = placesOf(curve, arrangement, window);
    Construction result;
    result.levels.resize(degree + 1);
    for (std::size_t k = 0; k <= degree; ++k) {
        const double weight =
            curve.weights.empty() ? 1 : curve.weights[arrangement.places[window + k].control];
        result.levels[0].push_back({curve.weights.empty() ? points[k] : weighted(points[k], weight),
                                    knots[k], knots[k + degree + 1]});
    }
    for (std::size_t level = 1; level <= degree; ++level) {
        const auto& below = result.levels[level - 1];
        for (std::size_t k = 0; k + level <= degree; ++k) {
            const double from = knots[k + level];
            const double to = knots[k + degree + 1];
            const double share = (inside - from) / (to - from);
            result.levels[level].push_back(
                {lerp(below[k].place, below[k + 1].place, share), from, to});
        }
    }
    if (!curve.weights.empty()) {
        project(result);
    }
    return result;
}

std::variant<Construction, Problem> barryGoldman(const Curve& curve, Spot spot) {
    if (auto problem = refusal(curve, {"catmull-rom"}, "pyramid of Barry and Goldman")) {
        return *problem;
    }
    const auto arrangement = arrangementOf(curve, curve.points);
    const auto segment = std::min(spot.segment, arrangement.pieces() - 1);
    const auto window = arrangement.windows[segment];
    const auto t = std::span(arrangement.knots).subspan(window, 4);
    const auto points = placesOf(curve, arrangement, window);
    const double u = spot.u > 0 ? std::min(spot.u, 1.0) : 0;
    const double before = t[1] - t[0], own = t[2] - t[1], after = t[3] - t[2];
    // From t[1], so that a piece far along the curve loses nothing.
    const double along = u * own;
    const auto share = [&](double done, double interval, double instead) {
        return interval > 0 ? done / interval : instead;
    };
    Construction result;
    for (std::size_t k = 0; k < 4; ++k) {
        result.levels.resize(1);
        result.levels[0].push_back({points[k], t[k], t[k]});
    }
    const Point first = lerp(points[0], points[1], share(before + along, before, 1));
    const Point middle = lerp(points[1], points[2], u);
    const Point last = lerp(points[2], points[3], share(along - own, after, 0));
    const Point left = lerp(first, middle, share(before + along, before + own, 1));
    const Point right = lerp(middle, last, share(along, own + after, 0));
    result.levels.push_back({{first, t[0], t[1]}, {middle, t[1], t[2]}, {last, t[2], t[3]}});
    result.levels.push_back({{left, t[0], t[2]}, {right, t[1], t[3]}});
    result.levels.push_back({{lerp(left, right, u), t[1], t[2]}});
    return result;
}

std::variant<Construction, Problem> neville(const Curve& curve, double t) {
    if (auto problem = refusal(curve, {"lagrange"}, "pyramid of Neville")) {
        return *problem;
    }
    const auto last = curve.points.size() - 1;
    const double inside = t > 0 ? std::min(t, 1.0) : 0;
    const auto knot = [&](std::size_t i) {
        return static_cast<double>(i) / static_cast<double>(last);
    };
    Construction result;
    result.levels.resize(last + 1);
    for (std::size_t i = 0; i <= last; ++i) {
        result.levels[0].push_back({curve.points.at(i), knot(i), knot(i)});
    }
    for (std::size_t level = 1; level <= last; ++level) {
        const auto& below = result.levels[level - 1];
        for (std::size_t i = 0; i + level <= last; ++i) {
            const double share = (inside - knot(i)) / (knot(i + level) - knot(i));
            result.levels[level].push_back(
                {lerp(below[i].place, below[i + 1].place, share), knot(i), knot(i + level)});
        }
    }
    return result;
}

} // namespace splineloft
