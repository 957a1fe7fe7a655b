// B-spline and NURBS: every curve of their form is one, with the right knots.
#include "core/spline/catalog.h"
#include "core/spline/change/knotted.h"
#include "core/spline/change/proposers.h"

#include <algorithm>
#include <numeric>

namespace splineloft::conversion {
namespace {

/// The points without those that doubled and reflected ends add.
Curve withoutAdded(const Curve& open, Ends ends) {
    Curve curve = open;
    curve.ends = ends;
    const auto window = static_cast<std::size_t>(layoutOf(curve).window);
    const auto added = (window - 1) / 2;
    curve.points = Points(open.points.dimension());
    curve.weights.clear();
    for (std::size_t i = added; i + added < open.points.size(); ++i) {
        curve.points.append(open.points.at(i));
        if (!open.weights.empty()) {
            curve.weights.push_back(open.weights[i]);
        }
    }
    return curve;
}

/// With uniform knots, which smooth pieces may have.
bool offerUniform(const Shape& shape, Trial& trial, const Curve& blank) {
    const auto curve = uniformlyKnotted(shape.pieces, blank);
    if (!curve) {
        return false;
    }
    if (shape.closed) {
        return trial.offer(*curve);
    }
    for (const Ends ends : {Ends::doubled, Ends::reflected}) {
        if (trial.offer(withoutAdded(*curve, ends))) {
            return true;
        }
    }
    Curve open = *curve;
    open.ends = Ends::open;
    return trial.offer(open);
}

/// A single piece, whose Bézier points are the control points of clamped ends.
bool offerClamped(const Shape& shape, Trial& trial, const Curve& blank) {
    auto curve = knotted(shape.pieces, knotsOfBezierPoints(shape.pieces, false), blank);
    if (!curve) {
        return false;
    }
    curve->knots.clear();
    curve->ends = Ends::clamped;
    return trial.offer(*curve);
}

/// The pieces between whole numbers, if some of them have no interval.
Pieces withIntervals(const Pieces& pieces) {
    bool all = true;
    std::vector<double> whole(pieces.size() + 1);
    std::iota(whole.begin(), whole.end(), 0.0);
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        all = all && pieces.knots().interval(i) > 0;
    }
    return all ? pieces
               : Pieces(pieces.degree(), pieces.dimension(), KnotLine(whole),
                        {pieces.bezier().begin(), pieces.bezier().end()}, pieces.form());
}

} // namespace

void proposeBSpline(const Shape& shape, Trial& trial) {
    const Pieces pieces = withIntervals(shape.pieces);
    const int degree = pieces.degree();
    Curve blank = trial.blank();
    blank.parameters["degree"] = degree;
    const auto needed = knotsNeeded(pieces, shape.closed, shape.tolerance);
    const auto inner = std::span(needed.times).subspan(1, needed.times.size() - 2);
    const bool smooth = std::ranges::all_of(inner, [](int times) { return times == 1; }) &&
                        (!shape.closed || needed.times.front() == 1);
    // Beyond a cubic, points found by reaching out from a single piece would be far away.
    const bool alone = shape.size() == 1 && !shape.closed && degree > 3;
    if (alone && offerClamped(shape, trial, blank)) {
        return;
    }
    if (smooth && shape.isUniform() && offerUniform(shape, trial, blank)) {
        return;
    }
    auto bezier = knotsOfBezierPoints(pieces, shape.closed);
    for (std::size_t i = 0; i < needed.times.size(); ++i) { // at gaps even more
        bezier.times[i] = std::max(bezier.times[i], needed.times[i]);
    }
    for (const auto& knots : {needed, bezier}) {
        const auto curve = knotted(pieces, knots, blank);
        if (curve && trial.offer(*curve)) {
            return;
        }
    }
}

} // namespace splineloft::conversion
