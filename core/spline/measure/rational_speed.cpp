#include "core/spline/measure/rational_speed.h"

#include "core/spline/algebra/scale.h"
#include "core/spline/ladder.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace splineloft {
namespace {

// A panel whose weights differ by more than this factor is not judged by its samples.
constexpr double mostUneven = 64;

/// The coefficients of (1 + t)^degree.
std::vector<double> binomials(std::size_t degree) {
    std::vector<double> row = {1};
    for (std::size_t k = 0; k < degree; ++k) { // a whole number each time
        row.push_back(row.back() * static_cast<double>(degree - k) / static_cast<double>(k + 1));
    }
    return row;
}

/// A polynomial by its powers, the constant first.
double horner(std::span<const double> powers, double t) {
    double value = 0;
    for (auto i = powers.size(); i-- > 0;) {
        value = value * t + powers[i];
    }
    return value;
}

/// The Bernstein coefficients over [start, end] of a polynomial that has `rungs` over [0, 1].
std::vector<double> partOf(std::vector<double> rungs, double start, double end) {
    std::vector<double> part;
    for (auto left = rungs.size(); left > 0; --left) {
        part.push_back(rungs.front());
        climb(std::span(rungs).first(left), end);
    }
    for (auto left = part.size(); left > 1; --left) {
        climb(std::span(part).first(left), end > 0 ? start / end : 0);
    }
    return part;
}

/// The weights, the largest of them between 1 and 2.
std::vector<double> weightsOf(const Piece& piece) {
    std::vector<double> weights = piece.column(piece.dimension);
    const double scale = std::ldexp(1.0, -std::ilogb(largestOf(weights)));
    std::ranges::transform(weights, weights.begin(), [=](double w) { return scale * w; });
    return weights;
}

/// The places of the Bézier points, one after the other; those too far for a number, as far as
/// numbers go.
std::vector<double> placesOf(const Piece& piece) {
    constexpr double most = std::numeric_limits<double>::max();
    std::vector<double> places;
    for (int i = 0; i <= piece.degree; ++i) {
        const Point place = piece.bezierPoint(i);
        for (const double x : place.coordinates()) {
            places.push_back(std::clamp(x, -most, most));
        }
    }
    return places;
}

/// Of the polygon through places in rows of `dimension` coordinates.
double lengthOfPolygon(std::span<const double> places, std::size_t dimension) {
    double length = 0;
    for (auto i = dimension; i < places.size(); i += dimension) {
        double square = 0;
        for (auto c = i; c < i + dimension; ++c) {
            const double leg = places[c] - places[c - dimension];
            square += leg * leg;
        }
        length += std::sqrt(square);
    }
    return length;
}

} // namespace

RationalSpeed::RationalSpeed(const Piece& piece, Half half)
    : half_(half), dimension_(static_cast<std::size_t>(piece.dimension)),
      weights_(weightsOf(piece)) {
    std::vector<double> places = placesOf(piece);
    const double scale = sixteenth * scaleFor(largestOf(places));
    std::ranges::transform(places, places.begin(), [=](double x) { return scale * x; });
    unit_ = 1 / scale;
    if (half_ == Half::second) {
        std::ranges::reverse(weights_);
        std::ranges::reverse(places); // with their coordinates, which the speed does not mind
    }
    const auto degree = weights_.size() - 1;
    const auto shares = binomials(degree);
    weightPowers_ = weights_;
    for (std::size_t i = 0; i <= degree; ++i) {
        weightPowers_[i] *= shares[i];
    }
    formVelocities(places);
    size_ = sizeOf(places);
}

void RationalSpeed::formVelocities(std::span<const double> places) {
    const auto degree = weights_.size() - 1;
    velocityCount_ = degree > 0 ? 2 * degree - 1 : 1;
    velocityPowers_.resize(velocityCount_ * dimension_);
    for (std::size_t j = 1; j <= degree; ++j) {
        for (std::size_t i = 0; i < j; ++i) {
            const double share = static_cast<double>(j - i) * (weightPowers_[i] * weightPowers_[j]);
            for (std::size_t c = 0; c < dimension_; ++c) {
                velocityPowers_[c * velocityCount_ + i + j - 1] +=
                    share * (places[j * dimension_ + c] - places[i * dimension_ + c]);
            }
        }
    }
    velocities_ = velocityPowers_;
    const auto over = binomials(velocityCount_ - 1);
    for (std::size_t i = 0; i < velocities_.size(); ++i) {
        velocities_[i] /= over[i % velocityCount_];
    }
}

/// The polygon of the Bézier points is not shorter than the piece. Where hardly any weight holds
/// points far away it is very much longer: chords between few spots tell more.
double RationalSpeed::sizeOf(std::span<const double> places) const {
    constexpr double shortest = 1e-10; // of the polygon
    constexpr int fewSpots = 18;
    const double polygon = lengthOfPolygon(places, dimension_);
    const auto [least, most] = std::ranges::minmax(weights_);
    if (most <= mostUneven * least) {
        return polygon;
    }
    std::vector<double> spots(places.begin(), places.begin() + static_cast<int>(dimension_));
    for (double t = std::ldexp(1.0, 4 - 4 * fewSpots); t <= 1; t *= 16) {
        const double weight = horner(weightPowers_, t);
        for (std::size_t c = 0; c < dimension_; ++c) {
            double sum = 0;
            for (auto i = weightPowers_.size(); i-- > 0;) {
                sum = sum * t + weightPowers_[i] * places[i * dimension_ + c];
            }
            spots.push_back(sum / weight);
        }
    }
    return std::max(lengthOfPolygon(spots, dimension_), shortest * polygon);
}

double RationalSpeed::at(double u) const {
    const double fromEnd = std::abs(u);
    const double over = 1 / (1 - fromEnd);
    const double t = fromEnd * over;
    double square = 0;
    for (std::size_t c = 0; c < dimension_; ++c) {
        const double velocity =
            horner(std::span(velocityPowers_).subspan(c * velocityCount_, velocityCount_), t);
        square += velocity * velocity;
    }
    const double slowing = over / horner(weightPowers_, t);
    return slowing * slowing * std::sqrt(square);
}

gauss::Samples RationalSpeed::on(double middle, double half) const {
    return samplesOf(*this, middle, half);
}

SpeedHull RationalSpeed::hullOn(double start, double end) const {
    const Stretch part = half_ == Half::first ? Stretch{start, end} : Stretch{-end, -start};
    const auto weights = partOf(weights_, part.start, part.end);
    const auto [least, most] = std::ranges::minmax(weights);
    std::vector<double> velocities(velocities_.size());
    for (std::size_t c = 0; c < dimension_; ++c) {
        const auto column = velocities_.begin() + static_cast<std::ptrdiff_t>(c * velocityCount_);
        const auto cut = partOf({column, column + static_cast<std::ptrdiff_t>(velocityCount_)},
                                part.start, part.end);
        for (std::size_t i = 0; i < velocityCount_; ++i) {
            velocities[i * dimension_ + c] = cut[i];
        }
    }
    SpeedHull hull = hullOf(velocities, dimension_);
    hull.fastest /= least * least;
    hull.least = most > mostUneven * least ? 0 : hull.least;
    return hull;
}

} // namespace splineloft
