#include "core/spline/change/trial.h"

#include "core/spline/catalog.h"
#include "core/spline/digits.h"

#include <algorithm>
#include <cmath>

namespace splineloft::conversion {
namespace {

/// Where two curves of as many pieces are farthest apart, and how far.
struct Gap {
    double length = 0;
    Spot spot;
};

Gap widestGap(const Pieces& one, const Pieces& other) {
    const int steps = std::max({8, one.degree(), other.degree()}); // enough to miss no polynomial
    Gap gap;
    for (std::size_t i = 0; i < one.size(); ++i) {
        for (int k = 0; k <= steps; ++k) {
            const Spot spot{i, static_cast<double>(k) / steps};
            const double length = distance(one.position(spot), other.position(spot));
            if (length > gap.length) {
                gap = {length, spot};
            }
        }
    }
    return gap;
}

std::string wordsOf(Spot spot) {
    const std::string segment = "segment " + std::to_string(spot.segment);
    return spot.u == 0   ? "where " + segment + " begins"
           : spot.u == 1 ? "where " + segment + " ends"
                         : "in " + segment + ", at u = " + twoDigits(spot.u) + ",";
}

} // namespace

Trial::Trial(const Shape& shape, const Curve& source, std::string_view family)
    : shape_(shape), source_(source), family_(family) {}

Curve Trial::blank() const {
    Curve result;
    result.name = source_.name;
    result.family = family_;
    result.coordinates = source_.coordinates;
    result.closed = source_.closed;
    result.ends = familyOf(result).ends.front();
    result.points = Points(source_.points.dimension());
    result.tangents = result.points;
    completeParameters(result);
    return result;
}

bool Trial::offer(const Curve& candidate) {
    if (auto problem = problemOf(candidate)) {
        problem_ = problem_ ? problem_ : problem;
        return false;
    }
    Pieces pieces = piecesOf(candidate);
    const auto difference = differenceOf(shape_.pieces, pieces);
    if (!difference) {
        return false;
    }
    if (difference->most <= shape_.tolerance) {
        found_ = found_ && !difference->sameParameter ? found_ : candidate;
        return difference->sameParameter || familyOf(candidate).spacing == Spacing::uniform;
    }
    if (!least_ || difference->most < least_->most) {
        least_ = difference;
        nearest_ = std::move(pieces);
    }
    return false;
}

std::string Trial::whyNot() const {
    if (nearest_) {
        const Gap gap = widestGap(shape_.pieces, *nearest_);
        return wordsOf(gap.spot) + " the curve would differ by " +
               twoDigits(std::scalbn(gap.length, shape_.exponent));
    }
    return problem_ ? "its " + problem_->place + " " + problem_->what + ", not " + problem_->remedy
                    : "none has as many pieces";
}

} // namespace splineloft::conversion
