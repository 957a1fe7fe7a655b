#include "core/spline/measure/speed.h"

#include "core/spline/algebra/scale.h"
#include "core/spline/shape/hodograph.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace splineloft {
namespace {} // namespace

SpeedHull hullOf(std::span<const double> velocities, std::size_t dimension) {
    constexpr double nothing = 1e-14; // of the fastest: rounding of what is zero
    const auto count = velocities.size() / dimension;
    const auto at = [&](std::size_t i) { return velocities.subspan(i * dimension, dimension); };
    const auto product = [](std::span<const double> a, std::span<const double> b) {
        double sum = 0;
        for (std::size_t k = 0; k < a.size(); ++k) {
            sum += a[k] * b[k];
        }
        return sum;
    };
    std::array<double, maxDimension> mean{};
    double largest2 = 0;
    SpeedHull hull;
    for (std::size_t i = 0; i < count; ++i) {
        const double square = product(at(i), at(i));
        largest2 = std::max(largest2, square);
        hull.fastest = std::max(hull.fastest, std::sqrt(square));
        for (std::size_t k = 0; k < dimension; ++k) {
            mean[k] += at(i)[k] / static_cast<double>(count);
        }
    }
    const auto rests = [&](std::size_t i) {
        return product(at(i), at(i)) <= nothing * nothing * largest2;
    };
    std::size_t first = 0;
    auto after = count;
    while (first < after && rests(first)) {
        ++first;
    }
    while (after > first && rests(after - 1)) {
        --after;
    }
    const auto middle = std::span<const double>(mean).first(dimension);
    const double size2 = product(middle, middle);
    hull.least = size2 > 0 ? 1 : 0;
    for (auto i = first; i < after && size2 > 0; ++i) {
        hull.least = std::min(hull.least, product(at(i), middle) / size2);
    }
    return hull;
}

template <int dimension> ParabolaSpeed<dimension>::ParabolaSpeed(const Piece& piece) {
    const double* const points = piece.coordinates.data();
    const double degree = piece.degree;
    // Bézier points of the hodograph.
    std::array<std::array<double, coordinates>, 3> legs{};
    const auto form = [&](std::size_t i) {
        for (std::size_t k = 0; k < coordinates; ++k) {
            const double* const from = points + i * coordinates + k;
            legs[i][k] = degree * (sixteenth * from[coordinates] - sixteenth * from[0]);
            size_ = std::max(size_, std::abs(legs[i][k]));
        }
    };
    if (piece.degree == 3) { // by far the most
        form(0), form(1), form(2);
    } else {
        for (int i = 0; i < piece.degree; ++i) {
            form(static_cast<std::size_t>(i));
        }
    }
    if (const double scale = scaleFor(size_); scale != 1) {
        for (auto& leg : legs) {
            std::ranges::transform(leg, leg.begin(), [=](double x) { return scale * x; });
        }
        size_ *= scale;
        unit_ /= scale;
    }
    for (std::size_t k = 0; k < coordinates; ++k) {
        velocity_.a[k] = legs[0][k];
        const double first = legs[1][k] - legs[0][k];
        const double second = legs[2][k] - legs[1][k];
        velocity_.b[k] = piece.degree < 2 ? 0 : piece.degree == 2 ? first : 2 * first;
        velocity_.c[k] = piece.degree < 3 ? 0 : second - first;
    }
}

template class ParabolaSpeed<1>;
template class ParabolaSpeed<2>;
template class ParabolaSpeed<3>;

LadderSpeed::LadderSpeed(const Piece& piece)
    : dimension_(static_cast<std::size_t>(piece.dimension)) {
    // First the numbers are made so small that neither differences nor products overflow, then the
    // hodograph's coordinates are brought to 1 at most.
    const double scale = sixteenth * scaleFor(largestOf(piece.coordinates));
    std::vector<double> scaled(piece.coordinates.begin(), piece.coordinates.end());
    std::ranges::transform(scaled, scaled.begin(), [=](double x) { return scale * x; });
    Piece small = piece;
    small.coordinates = scaled;
    const Pieces derivative = hodograph(small);
    coordinates_.assign(derivative.bezier().begin(), derivative.bezier().end());
    rungs_.resize(coordinates_.size());
    const double largest = largestOf(coordinates_);
    const bool rests = largest < std::numeric_limits<double>::min();
    std::ranges::transform(coordinates_, coordinates_.begin(),
                           [=](double x) { return rests ? 0 : x / largest; });
    unit_ = rests ? 1 : std::min(largest / scale, std::numeric_limits<double>::max());
    const Piece whole{coordinates_, derivative.degree(), piece.dimension};
    for (int i = 0; i <= whole.degree; ++i) {
        size_ += norm(whole.bezierPoint(i)) / (whole.degree + 1);
    }
}

/// One level of de Casteljau's ladder: the points but the last are replaced.
void LadderSpeed::climbAll(std::span<double> rungs, double u) const {
    for (std::size_t i = 0; i + dimension_ < rungs.size(); ++i) {
        rungs[i] = lerp(rungs[i], rungs[i + dimension_], u);
    }
}

double LadderSpeed::at(double u) const {
    std::ranges::copy(coordinates_, rungs_.begin());
    for (auto left = rungs_.size(); left > dimension_; left -= dimension_) {
        climbAll(std::span(rungs_).first(left), u);
    }
    double sum = 0;
    for (std::size_t k = 0; k < dimension_; ++k) {
        sum += rungs_[k] * rungs_[k];
    }
    return std::sqrt(sum);
}

gauss::Samples LadderSpeed::on(double middle, double half) const {
    return samplesOf(*this, middle, half);
}

SpeedHull LadderSpeed::hullOn(double start, double end) const {
    // What is left of `end`, and of that what is right of `start`.
    std::ranges::copy(coordinates_, rungs_.begin());
    std::vector<double> part;
    part.reserve(rungs_.size());
    for (auto left = rungs_.size(); left > 0; left -= dimension_) {
        part.insert(part.end(), rungs_.begin(), rungs_.begin() + static_cast<int>(dimension_));
        climbAll(std::span(rungs_).first(left), end);
    }
    for (auto left = part.size(); left > dimension_; left -= dimension_) {
        climbAll(std::span(part).first(left), end > 0 ? start / end : 0);
    }
    return hullOf(part, dimension_);
}

} // namespace splineloft
