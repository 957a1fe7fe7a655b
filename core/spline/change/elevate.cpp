// Degree elevation of curves: the pieces are raised, and the knots that join them stand once more.
#include "core/spline/change/convert.h"
#include "core/spline/change/knots.h"
#include "core/spline/change/knotted.h"
#include "core/spline/change/shape.h"

#include <algorithm>

namespace splineloft {
namespace {

using conversion::JointKnots;

/// The knots where pieces of the curve meet, each once more than it stands.
JointKnots oneMoreEach(const Curve& curve, const Pieces& pieces) {
    JointKnots knots;
    const auto degree = pieces.degree();
    for (std::size_t i = 0; i <= pieces.size(); ++i) {
        const double at = pieces.knots().knots()[i];
        const bool end = !curve.closed && (i == 0 || i == pieces.size());
        const auto standing = conversion::timesOf(curve, at);
        knots.at.push_back(at);
        knots.times.push_back(end ? degree + 2 : static_cast<int>(standing) + 1);
    }
    return knots;
}

/// The same, or more where that takes Bézier points for control points.
JointKnots atLeast(const JointKnots& least, const Pieces& pieces, bool closed) {
    JointKnots knots = conversion::knotsOfBezierPoints(pieces, closed);
    for (std::size_t i = 0; i < knots.times.size(); ++i) {
        knots.times[i] = std::max(knots.times[i], least.times[i]);
    }
    return knots;
}

bool agrees(const Curve& curve, const Pieces& pieces, double tolerance) {
    if (problemOf(curve)) {
        return false;
    }
    const auto difference = differenceOf(pieces, piecesOf(curve));
    return difference && difference->most <= tolerance;
}

std::variant<Curve, Problem> elevatedBezier(const Curve& curve, const Pieces& pieces) {
    Curve result = curve;
    result.points = Points(curve.points.dimension());
    for (const auto& point : elevated(pieces[0], pieces.degree() + 1)) {
        result.points.append(point);
    }
    return checked(std::move(result));
}

std::variant<Curve, Problem> elevatedSpline(const Curve& curve) {
    auto own = withOwnKnots(curve);
    if (std::holds_alternative<Problem>(own)) {
        return own;
    }
    auto& written = std::get<Curve>(own);
    Pieces pieces = piecesOf(written);
    if (curve.weights.empty()) {
        pieces = conversion::withoutIdleWeights(pieces);
    }
    const auto knots = oneMoreEach(written, pieces);
    Curve blank = written;
    blank.points = Points(curve.points.dimension());
    blank.weights.clear();
    blank.parameters["degree"] = pieces.degree() + 1;
    const Pieces high = conversion::raised(pieces, pieces.degree() + 1);
    auto result = conversion::knotted(high, knots, blank);
    const double tolerance = conversion::toleranceOf(pieces);
    if (!result || !agrees(*result, pieces, tolerance)) {
        // The highest degrees reach out so far from a piece that rounding shows.
        result = conversion::knotted(high, atLeast(knots, high, curve.closed), blank);
    }
    if (!result) {
        return Problem{"/weights", "differ too much", "weights nearer to each other"};
    }
    return checked(std::move(*result));
}

} // namespace

std::variant<Curve, Problem> elevated(const Curve& curve) {
    if (auto problem = problemOf(curve)) {
        return *problem;
    }
    if (familyOf(curve).usesKnots) {
        return elevatedSpline(curve);
    }
    if (curve.family != "bezier") {
        return Problem{"/family", "curves of the family " + curve.family + " have a fixed degree",
                       "bezier, b-spline or nurbs: convert the curve first"};
    }
    const Pieces pieces = piecesOf(curve);
    if (pieces.empty()) {
        return Problem{"/points", "has too few points for a piece", "2 points or more"};
    }
    return elevatedBezier(curve, pieces);
}

} // namespace splineloft
