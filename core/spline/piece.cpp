#include "core/spline/piece.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace splineloft {
namespace {

/// Curvature from the first two derivatives: |P' x P''| / |P'|^3. Both are scaled by the speed
/// first so that neither very slow nor very fast parametrisations lose it.
std::optional<double> curvatureOf(const Point& first, const Point& second) {
    const double speed = norm(first);
    if (speed < std::numeric_limits<double>::min()) { // below it 1 / speed overflows
        return std::nullopt;
    }
    const Point tangent = (1 / speed) * first;
    const Point turning = (1 / speed) * second;
    const double curvature = first.dimension() == 2
                                 ? (tangent[0] * turning[1] - tangent[1] * turning[0]) / speed
                                 : norm(turning - dot(turning, tangent) * tangent) / speed;
    return std::isfinite(curvature) ? std::optional(curvature) : std::nullopt;
}

} // namespace

Spot KnotLine::locate(double t) const {
    if (pieces() == 0) {
        return {};
    }
    if (!(t > start())) {
        t = start();
    }
    if (t >= end()) {
        // The last piece that has an interval, so that the end is reached from inside it.
        auto last = pieces() - 1;
        while (last > 0 && interval(last) == 0) {
            --last;
        }
        return {last, 1};
    }
    const auto after = std::upper_bound(knots_.begin(), knots_.end(), t);
    const auto segment = static_cast<std::size_t>(after - knots_.begin()) - 1;
    return {segment, (t - knots_[segment]) / interval(segment)};
}

double KnotLine::parameter(Spot spot) const {
    return lerp(knots_[spot.segment], knots_[spot.segment + 1], spot.u);
}

Point Piece::bezierPoint(int index) const {
    const auto width = static_cast<std::size_t>(dimension);
    return Point(coordinates.subspan(static_cast<std::size_t>(index) * width, width));
}

Ladder<Point> Piece::ladder(double u) const {
    std::vector<Point> points;
    for (int i = 0; i <= degree; ++i) {
        points.push_back(bezierPoint(i));
    }
    return Ladder<Point>(points, u);
}

Point Piece::position(double u) const {
    return jet(u).position;
}

Jet Piece::jet(double u) const {
    Jet jet{Point(dimension), Point(dimension), Point(dimension), std::nullopt};
    const auto width = static_cast<std::size_t>(dimension);
    const auto count = static_cast<std::size_t>(degree) + 1;
    const double d = degree;
    // Most curves are of low degree: their rungs need no allocation.
    std::array<double, 32> few{};
    std::vector<double> many(count > few.size() ? count : 0);
    const auto rungs = many.empty() ? std::span(few).first(count) : std::span(many);
    for (int c = 0; c < dimension; ++c) {
        for (std::size_t i = 0; i < count; ++i) {
            rungs[i] = coordinates[i * width + static_cast<std::size_t>(c)];
        }
        for (std::size_t left = count; left > 1; --left) {
            if (left == 3) {
                jet.second[c] = d * (d - 1) * ((rungs[2] - rungs[1]) - (rungs[1] - rungs[0]));
            }
            if (left == 2) {
                jet.first[c] = d * (rungs[1] - rungs[0]);
            }
            climb(rungs.first(left), u);
        }
        jet.position[c] = rungs[0];
    }
    jet.curvature = curvatureOf(jet.first, jet.second);
    return jet;
}

std::vector<double> Piece::hodograph() const {
    const auto width = static_cast<std::size_t>(dimension);
    std::vector<double> derivative;
    for (std::size_t i = width; i < coordinates.size(); ++i) {
        derivative.push_back(degree * (coordinates[i] - coordinates[i - width]));
    }
    return derivative;
}

Pieces::Pieces(int degree, int dimension, KnotLine knots, std::vector<double> bezier)
    : degree_(degree), dimension_(dimension), knots_(std::move(knots)), bezier_(std::move(bezier)) {
}

Piece Pieces::operator[](std::size_t segment) const {
    const auto length = static_cast<std::size_t>((degree_ + 1) * dimension_);
    return {std::span(bezier_).subspan(segment * length, length), degree_, dimension_};
}

Jet Pieces::jetByParameter(Spot spot) const {
    Jet jet = this->jet(spot);
    const double interval = knots_.interval(spot.segment);
    if (interval > 0) {
        jet.first *= 1 / interval;
        jet.second *= 1 / interval;
        jet.second *= 1 / interval;
    }
    return jet;
}

BlendPieces::BlendPieces(int degree, std::size_t controlPoints, KnotLine knots,
                         std::vector<Blend> bezier)
    : degree_(degree), controlPoints_(controlPoints), knots_(std::move(knots)),
      bezier_(std::move(bezier)) {}

std::span<const Blend> BlendPieces::operator[](std::size_t segment) const {
    const auto count = static_cast<std::size_t>(degree_) + 1;
    return std::span(bezier_).subspan(segment * count, count);
}

Blend BlendPieces::basis(Spot spot) const {
    const auto bezier = (*this)[spot.segment];
    std::vector<Blend> rungs(bezier.begin(), bezier.end());
    for (std::size_t left = rungs.size(); left > 1; --left) {
        climb(std::span(rungs).first(left), spot.u);
    }
    return rungs.front();
}

} // namespace splineloft
