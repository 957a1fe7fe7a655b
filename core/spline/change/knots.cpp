#include "core/spline/change/knots.h"

#include "core/spline/arrangement.h"
#include "core/spline/change/knotted.h"
#include "core/spline/digits.h"
#include "core/spline/problem.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace splineloft {
namespace {

bool hasKnots(const Curve& curve) {
    return familyOf(curve).usesKnots;
}

Problem withoutKnots(const Curve& curve) {
    return {"/family", "the family " + curve.family + " has no knots",
            "b-spline or nurbs: convert the curve first"};
}

std::size_t degreeOf(const Curve& curve) {
    return static_cast<std::size_t>(parameterOf(curve, "degree"));
}

/// A B-spline's polygon, as far as its pieces read it: homogeneous points, and the knots.
/// Control point i has the knots i + 1 to i + degree.
struct Polygon {
    std::vector<Point> points;
    std::vector<double> knots;
};

Point homogeneous(const Point& place, double weight) {
    Point point(place.dimension() + 1);
    for (int c = 0; c < place.dimension(); ++c) {
        point[c] = weight * place[c];
    }
    point[place.dimension()] = weight;
    return point;
}

/// Point i of a curve that has weights if `rational`.
Point homogeneousAt(const Curve& curve, std::size_t i) {
    const Point place = curve.points.at(i);
    return curve.weights.empty() ? place : homogeneous(place, curve.weights[i]);
}

void append(Curve& curve, const Point& point) {
    const int dimension = curve.points.dimension();
    if (point.dimension() == dimension) {
        curve.points.append(point);
        return;
    }
    const Point place(point.coordinates().first(static_cast<std::size_t>(dimension)));
    curve.points.append((1 / point[dimension]) * place);
    curve.weights.push_back(point[dimension]);
}

/// The curve with this polygon, of which it takes `count` points from number `first` on.
Curve withPolygon(const Curve& curve, const Polygon& polygon, std::size_t first,
                  std::size_t count) {
    Curve result = curve;
    result.points = Points(curve.points.dimension());
    result.points.reserve(count);
    result.weights.clear();
    for (std::size_t i = first; i < first + count; ++i) {
        append(result, polygon.points[i]);
    }
    return result;
}

/// One more knot t between knots number `span` and `span` + 1, where it stands `times` times
/// already. The points that lose a leg to it are replaced by points on their legs.
void insertKnot(Polygon& polygon, std::size_t degree, double t, std::size_t span,
                std::size_t times) {
    auto& [points, knots] = polygon;
    // Number i, which has the knots i + 1 to i + degree, of which t now pushes one out.
    const std::size_t first = span + 1 - degree;
    const std::size_t end = span + 1 - times;
    std::vector<Point> fresh;
    for (std::size_t i = first; i < end; ++i) {
        const double a = knots[i];
        fresh.push_back(lerp(points[i - 1], points[i], (t - a) / (knots[i + degree] - a)));
    }
    const auto at = [](auto& list, std::size_t i) {
        return list.begin() + static_cast<std::ptrdiff_t>(i);
    };
    // One fewer is replaced than comes in; without any, the point before is there twice.
    if (fresh.empty()) {
        const Point twice = points[first - 1];
        points.insert(at(points, first), twice);
    } else {
        points.insert(at(points, first), fresh.front());
        std::copy(fresh.begin() + 1, fresh.end(), at(points, first + 1));
    }
    knots.insert(at(knots, span + 1), t);
}

std::optional<Problem> insertionProblem(const Curve& curve, double t, int times,
                                        std::size_t standing, std::size_t most) {
    const auto wanted = standing + static_cast<std::size_t>(times);
    if (wanted <= most) {
        return std::nullopt;
    }
    return Problem{"/knots",
                   "would have the knot " + allDigits(t) + " " + std::to_string(wanted) + " times",
                   "each at most " + std::to_string(most) + " times" +
                       (curve.closed ? " on a closed curve" : "")};
}

std::variant<Curve, Problem> withKnotOfOpen(const Curve& curve, double t, int times) {
    const auto degree = degreeOf(curve);
    Polygon polygon{{}, curve.knots};
    for (std::size_t i = 0; i < curve.points.size(); ++i) {
        polygon.points.push_back(homogeneousAt(curve, i));
    }
    const auto [low, high] = std::equal_range(curve.knots.begin(), curve.knots.end(), t);
    const auto standing = static_cast<std::size_t>(high - low);
    if (auto problem = insertionProblem(curve, t, times, standing, degree + 1)) {
        return *problem;
    }
    auto span = static_cast<std::size_t>(high - curve.knots.begin()) - 1;
    for (std::size_t k = 0; k < static_cast<std::size_t>(times); ++k) {
        insertKnot(polygon, degree, t, span + k, standing + k);
    }
    Curve result = withPolygon(curve, polygon, 0, polygon.points.size());
    result.knots = polygon.knots;
    return result;
}

/// A closed curve unrolled: one turn, and on either side the knots that its points look into and
/// those that these look into.
struct Unrolled {
    Polygon polygon;
    std::size_t origin = 0; ///< number of the first own knot among all
};

Unrolled unrolled(const Curve& curve, std::size_t degree) {
    const auto n = curve.points.size();
    const double period = curve.knots.back() - curve.knots.front();
    const std::size_t lead = (degree - 1) / 2;
    const std::size_t margin = 3 * (degree + 1);
    const std::size_t turnsBefore = margin / n + 1;
    Unrolled result;
    result.origin = margin;
    const auto all = n + 2 * margin;
    for (std::size_t i = 0; i < all; ++i) {
        const auto at = i + turnsBefore * n - margin;
        const double turn = static_cast<double>(at / n) - static_cast<double>(turnsBefore);
        result.polygon.knots.push_back(curve.knots[at % n] + turn * period);
        // Number i has the knots i + 1 to i + degree; the curve's point j those about its knot j.
        if (i + degree + 1 < all) {
            result.polygon.points.push_back(homogeneousAt(curve, (at + degree + n - lead) % n));
        }
    }
    return result;
}

std::variant<Curve, Problem> withKnotOfClosed(const Curve& curve, double at, int times) {
    const auto degree = degreeOf(curve);
    const double period = curve.knots.back() - curve.knots.front();
    const double t = at == curve.knots.back() ? curve.knots.front() : at;
    if (auto problem = insertionProblem(curve, t, times, conversion::timesOf(curve, t), degree)) {
        return *problem;
    }
    Curve result = curve;
    for (int k = 0; k < times; ++k) {
        const auto n = result.points.size();
        const auto standing = conversion::timesOf(result, t);
        const auto after = std::ranges::upper_bound(result.knots, t);
        const auto span = static_cast<std::size_t>(after - result.knots.begin()) - 1;
        auto [polygon, origin] = unrolled(result, degree);
        // At each turn that has all it takes, from behind, so that numbers stay what they are.
        const auto turnsBefore = (origin + span) / n;
        const auto turnsAfter = (polygon.knots.size() - origin - span) / n;
        std::size_t before = 0; // of them before the curve's own turn
        for (std::size_t turn = turnsBefore + turnsAfter + 1; turn-- > 0;) {
            const auto here = origin + span + turn * n - turnsBefore * n;
            if (here >= degree && here + degree + 1 < polygon.knots.size()) {
                const double shift = static_cast<double>(turn) - static_cast<double>(turnsBefore);
                insertKnot(polygon, degree, t + shift * period, here, standing);
                before += turn < turnsBefore ? 1 : 0;
            }
        }
        const std::size_t lead = (degree - 1) / 2;
        const auto first = origin + before + lead - degree;
        std::vector<double> knots = result.knots;
        knots.insert(knots.begin() + static_cast<std::ptrdiff_t>(span + 1), t);
        result = withPolygon(result, polygon, first, n + 1);
        result.knots = std::move(knots);
    }
    return result;
}

} // namespace

std::variant<Curve, Problem> withOwnKnots(const Curve& curve) {
    if (auto problem = problemOf(curve)) {
        return *problem;
    }
    if (!hasKnots(curve)) {
        return withoutKnots(curve);
    }
    if (!curve.knots.empty()) {
        return curve;
    }
    const auto arrangement = arrangementOf(curve, curve.points);
    if (arrangement.pieces() == 0) {
        return Problem{"/points", "has too few points for a piece",
                       std::to_string(fewestPoints(curve)) + " points or more"};
    }
    Curve result = curve;
    result.parameters["alpha"] = 0; // which own knots make idle
    result.ends = Ends::none;
    if (curve.closed) {
        const auto from = arrangement.knots.begin() + static_cast<std::ptrdiff_t>(degreeOf(curve));
        result.knots.assign(from, from + static_cast<std::ptrdiff_t>(curve.points.size()) + 1);
        return checked(std::move(result));
    }
    result.knots = arrangement.knots;
    result.points = Points(curve.points.dimension());
    result.weights.clear();
    for (const auto& place : arrangement.places) {
        const Point own = curve.points.at(place.control);
        result.points.append(place.mirroredAt ? 2.0 * curve.points.at(*place.mirroredAt) - own
                                              : own);
        if (!curve.weights.empty()) {
            result.weights.push_back(curve.weights[place.control]);
        }
    }
    return checked(std::move(result));
}

std::variant<Curve, Problem> withKnot(const Curve& curve, double t, int times) {
    auto own = withOwnKnots(curve);
    if (std::holds_alternative<Problem>(own)) {
        return own;
    }
    const auto& written = std::get<Curve>(own);
    const Pieces pieces = piecesOf(written);
    if (pieces.empty()) {
        return Problem{"/points", "has too few points for a piece", "more points"};
    }
    const double start = pieces.knots().start();
    const double end = pieces.knots().end();
    if (!(t >= start && t <= end)) {
        return Problem{"/knots", "cannot take " + allDigits(t) + ", which is not on the curve",
                       "a value from " + allDigits(start) + " to " + allDigits(end)};
    }
    if (times < 1) {
        return Problem{"/knots", "cannot take a knot " + std::to_string(times) + " times",
                       "once or more"};
    }
    auto result =
        written.closed ? withKnotOfClosed(written, t, times) : withKnotOfOpen(written, t, times);
    return std::holds_alternative<Problem>(result) ? result
                                                   : checked(std::get<Curve>(std::move(result)));
}

} // namespace splineloft
