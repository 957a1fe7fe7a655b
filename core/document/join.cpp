// Two curves made one.
#include "core/document/curve_edits.h"
#include "core/document/excerpt.h"
#include "core/document/handles.h"
#include "core/document/reversal.h"
#include "core/spline/change/convert.h"
#include "core/spline/change/knots.h"

#include <algorithm>
#include <cmath>

namespace splineloft {
namespace {

// Ends this close, as a part of the largest coordinate, are one point.
constexpr double together = 1e-12;

using MaybeCurve = std::variant<Curve, Problem>;

double largestCoordinateOf(const Curve& curve) {
    double most = 0;
    for (const double value : curve.points.values()) {
        most = std::max(most, std::abs(value));
    }
    return most;
}

Point lastOf(const Curve& curve) {
    return curve.points.at(curve.points.size() - 1);
}

bool meet(const Curve& first, const Curve& second) {
    return distance(lastOf(first), second.points.at(0)) <=
           together * std::max(largestCoordinateOf(first), largestCoordinateOf(second));
}

/// Control points beyond the last whole piece, which nothing can follow.
std::size_t waiting(const Curve& curve) {
    return (curve.points.size() - 1) % static_cast<std::size_t>(layoutOf(curve).stride);
}

std::optional<Problem> familyProblem(const Curve& curve) {
    const auto layout = layoutOf(curve);
    if (layout.stride == layout.window) {
        return Problem{"/family", "a curve of the family " + curve.family + " is one piece",
                       "bezier-spline: convert the curves first"};
    }
    return std::nullopt;
}

/// Makes parameters local of which the curves have different values.
std::optional<Problem> reconcileParameters(Curve& first, Curve& second) {
    for (const auto& parameter : familyOf(first).parameters) {
        const std::string key(parameter.key);
        const bool isLocal = first.local.contains(key) || second.local.contains(key);
        if (!isLocal && parameterOf(first, key) == parameterOf(second, key)) {
            continue;
        }
        if (!parameter.local) {
            return Problem{"/parameters/" + key, "differs from that of the other curve",
                           "one value of \"" + key + "\" for both"};
        }
        for (auto* curve : {&first, &second}) {
            curve->local.try_emplace(key, curve->points.size(), parameterOf(*curve, key));
        }
    }
    return std::nullopt;
}

void appendPoint(Curve& curve, const Curve& from, std::size_t index) {
    curve.points.append(from.points.at(index));
    if (!from.tangents.empty()) {
        curve.tangents.append(from.tangents.at(index));
    }
    for (auto& [key, values] : curve.local) {
        values.push_back(from.local.at(key)[index]);
    }
}

/// The last point of the first curve becomes the first one of the second, too.
void share(Curve& first, const Curve& second) {
    const auto last = first.points.size() - 1;
    if (!first.tangents.empty()) {
        first.tangents.set(last, 0.5 * (first.tangents.at(last) + second.tangents.at(0)));
    }
    for (auto& [key, values] : first.local) {
        values[last] = 0.5 * (values[last] + second.local.at(key)[0]);
    }
}

/// Points one after the other.
MaybeCurve chained(Curve first, Curve second) {
    if (auto problem = familyProblem(first)) {
        return *problem;
    }
    for (const auto* curve : {&first, &second}) {
        if (waiting(*curve) > 0) {
            return Problem{"/points", "has control points beyond its last segment",
                           "a curve that ends with a whole segment"};
        }
    }
    if (auto problem = reconcileParameters(first, second)) {
        return *problem;
    }
    const bool shared = meet(first, second);
    if (shared) {
        share(first, second);
    } else { // a straight leg
        const auto stride = layoutOf(first).stride;
        const Point from = lastOf(first);
        for (int k = 1; k < stride; ++k) {
            first.points.append(lerp(from, second.points.at(0), static_cast<double>(k) / stride));
        }
    }
    for (std::size_t i = shared ? 1 : 0; i < second.points.size(); ++i) {
        appendPoint(first, second, i);
    }
    return first;
}

/// Two b-spline or nurbs curves that are clamped at their ends, of one degree, and meet.
Curve knottedTogether(Curve first, const Curve& second) {
    const double weight = first.weights.empty() ? 1 : first.weights.back();
    if (!first.weights.empty() || !second.weights.empty()) {
        first.weights.resize(first.points.size(), 1);
        const double scale = weight / (second.weights.empty() ? 1 : second.weights.front());
        for (std::size_t i = 1; i < second.points.size(); ++i) {
            first.weights.push_back(scale * (second.weights.empty() ? 1 : second.weights[i]));
        }
    }
    for (std::size_t i = 1; i < second.points.size(); ++i) {
        first.points.append(second.points.at(i));
    }
    const auto degree = static_cast<std::size_t>(parameterOf(first, "degree"));
    const double shift = first.knots.back() - second.knots.front();
    first.knots.pop_back();
    for (auto i = degree + 1; i < second.knots.size(); ++i) {
        first.knots.push_back(second.knots[i] + shift);
    }
    return first;
}

/// A straight curve like `like` from its end to `to`.
Curve legFrom(const Curve& like, const Point& to) {
    Curve leg = like;
    const auto degree = static_cast<int>(parameterOf(like, "degree"));
    leg.points = Points(to.dimension());
    for (int k = 0; k <= degree; ++k) {
        leg.points.append(lerp(lastOf(like), to, static_cast<double>(k) / degree));
    }
    leg.weights.clear();
    leg.knots.assign(static_cast<std::size_t>(degree) + 1, 0.0);
    leg.knots.resize(2 * leg.knots.size(), 1.0);
    return leg;
}

MaybeCurve elevatedTo(Curve curve, double degree) {
    while (parameterOf(curve, "degree") < degree) {
        auto higher = elevated(curve);
        if (std::holds_alternative<Problem>(higher)) {
            return higher;
        }
        curve = std::get<Curve>(std::move(higher));
    }
    return curve;
}

MaybeCurve joinedKnots(const Curve& first, const Curve& second) {
    const double degree = std::max(parameterOf(first, "degree"), parameterOf(second, "degree"));
    std::vector<Curve> parts;
    for (const auto* curve : {&first, &second}) {
        auto high = elevatedTo(*curve, degree);
        if (std::holds_alternative<Problem>(high)) {
            return high;
        }
        auto clamped = clampedAtEnds(std::get<Curve>(high));
        if (!clamped) {
            return Problem{"/points", "cannot be given an end that stays where it is",
                           "a curve with pieces, and weights nearer to each other"};
        }
        parts.push_back(std::move(*clamped));
    }
    if (!meet(parts[0], parts[1])) {
        parts[0] = knottedTogether(parts[0], legFrom(parts[0], parts[1].points.at(0)));
    }
    return knottedTogether(parts[0], parts[1]);
}

std::optional<Problem> endProblem(const Document& document, const PointId& id) {
    const Curve& curve = *document.curves[id.curve];
    const auto index = anchorOf(curve, id.index).value_or(id.index);
    if (curve.closed) {
        return Problem{"/closed", "is a closed curve, which has no end", "an open curve"};
    }
    if (curve.points.empty() || (index != 0 && index + 1 != curve.points.size())) {
        return Problem{"/points/" + std::to_string(id.index), "is not at an end of its curve",
                       "the first or the last control point"};
    }
    return std::nullopt;
}

Problem within(std::size_t curve, Problem problem) {
    problem.place = "/curves/" + std::to_string(curve) + problem.place;
    return problem;
}

/// The other curve as one of the family, in the direction that is wanted.
std::variant<CurveEntry, Problem> fitted(const CurveEntry& other, const Curve& one,
                                         bool backwards) {
    CurveEntry result = other;
    if (other->family != one.family) {
        auto same = converted(*other, one.family);
        if (const auto* problem = std::get_if<Problem>(&same)) {
            return *problem;
        }
        result = std::make_shared<Curve>(std::get<Curve>(std::move(same)));
        result.handleModes.clear();
    }
    return backwards ? reversed(result) : result;
}

} // namespace

std::variant<Document, Problem> joinCurves(const Document& document, PointId end,
                                           PointId otherEnd) {
    for (const auto& id : {end, otherEnd}) {
        if (auto problem = endProblem(document, id)) {
            return within(id.curve, *problem);
        }
    }
    const CurveEntry& one = document.curves[end.curve];
    const CurveEntry& given = document.curves[otherEnd.curve];
    if (end.curve == otherEnd.curve) {
        return within(end.curve, {"", "has both ends", "ends of two curves; or close the curve"});
    }
    if (one->points.dimension() != given->points.dimension()) {
        return within(otherEnd.curve, {"/points",
                                       "have " + std::to_string(given->points.dimension()) +
                                           " coordinates where the other curve's have " +
                                           std::to_string(one->points.dimension()),
                                       "two curves with as many coordinates"});
    }
    // The first curve keeps its direction: the other one follows it, or leads up to it.
    const bool follows = anchorOf(*one, end.index).value_or(end.index) != 0;
    const bool startsThere = anchorOf(*given, otherEnd.index).value_or(otherEnd.index) == 0;
    const auto other = fitted(given, *one, follows != startsThere);
    if (const auto* problem = std::get_if<Problem>(&other)) {
        return within(otherEnd.curve, *problem);
    }
    const auto& fitting = std::get<CurveEntry>(other);
    const CurveEntry& first = follows ? one : fitting;
    const CurveEntry& second = follows ? fitting : one;
    auto joined =
        familyOf(*one).usesKnots ? joinedKnots(*first, *second) : chained(*first, *second);
    if (const auto* problem = std::get_if<Problem>(&joined)) {
        return within(otherEnd.curve, *problem);
    }
    auto curve = std::make_shared<Curve>(std::get<Curve>(std::move(joined)));
    curve->name = one->name;
    curve->coordinates = one->coordinates;
    if (auto problem = problemOf(*curve)) {
        return within(end.curve, *problem);
    }
    Document next = document;
    auto& entry = next.curves[end.curve];
    const auto offset = curve->points.size() - second->points.size();
    entry.handleModes = first.handleModes;
    for (const auto& [anchor, mode] : second.handleModes) {
        entry.handleModes[anchor + offset] = mode;
    }
    settleModes(*curve, entry.handleModes);
    entry = std::move(curve);
    next.curves.erase(next.curves.begin() + static_cast<std::ptrdiff_t>(otherEnd.curve));
    return next;
}

} // namespace splineloft
