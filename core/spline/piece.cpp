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

/// From homogeneous coordinates to the place: all but the last, divided by the last.
Point projected(const Point& homogeneous) {
    const int dimension = homogeneous.dimension() - 1;
    const Point place(homogeneous.coordinates().first(static_cast<std::size_t>(dimension)));
    return (1 / homogeneous[dimension]) * place;
}

/// The first coordinates of a homogeneous point, without the weight.
Point numerators(const Point& homogeneous) {
    return Point(
        homogeneous.coordinates().first(static_cast<std::size_t>(homogeneous.dimension() - 1)));
}

/// The quotient rule, twice: from A = w P follow A' = w' P + w P' and
/// A'' = w'' P + 2 w' P' + w P''.
Jet projected(const Jet& homogeneous) {
    const int last = homogeneous.position.dimension() - 1;
    const double over = 1 / homogeneous.position[last];
    const double w1 = homogeneous.first[last];
    const double w2 = homogeneous.second[last];
    Jet jet;
    jet.position = over * numerators(homogeneous.position);
    jet.first = over * (numerators(homogeneous.first) - w1 * jet.position);
    jet.second = over * (numerators(homogeneous.second) - 2 * w1 * jet.first - w2 * jet.position);
    return jet;
}

} // namespace

void KnotLine::move(std::size_t first, std::span<const double> knots) {
    std::ranges::copy(knots, knots_.begin() + static_cast<std::ptrdiff_t>(first));
}

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
    const auto stride = static_cast<std::size_t>(width());
    const Point own(coordinates.subspan(static_cast<std::size_t>(index) * stride, stride));
    return form == Form::rational ? projected(own) : own;
}

double Piece::weight(int index) const {
    return form == Form::rational ? coordinates[static_cast<std::size_t>((index + 1) * width() - 1)]
                                  : 1;
}

std::vector<double> Piece::column(int coordinate) const {
    std::vector<double> values;
    for (int i = 0; i <= degree; ++i) {
        values.push_back(coordinates[static_cast<std::size_t>(i * width() + coordinate)]);
    }
    return values;
}

Ladder<Point> Piece::ladder(double u) const {
    std::vector<Point> points;
    const auto stride = static_cast<std::size_t>(width());
    for (std::size_t i = 0; i <= static_cast<std::size_t>(degree); ++i) {
        points.emplace_back(coordinates.subspan(i * stride, stride));
    }
    const Ladder<Point> ladder(points, u);
    return form == Form::rational ? ladder.mapped([](const Point& p) { return projected(p); })
                                  : ladder;
}

Point Piece::position(double u) const {
    if (degree != 3) {
        return jet(u).position;
    }
    // By far the most are cubic: the same without loops and derivatives.
    const auto stride = static_cast<std::size_t>(width());
    Point tip(width());
    for (std::size_t c = 0; c < stride; ++c) {
        const double* const p = &coordinates[c];
        const double middle = lerp(p[stride], p[2 * stride], u);
        const double before = lerp(lerp(p[0], p[stride], u), middle, u);
        const double after = lerp(middle, lerp(p[2 * stride], p[3 * stride], u), u);
        tip[static_cast<int>(c)] = lerp(before, after, u);
    }
    return form == Form::rational ? projected(tip) : tip;
}

Jet Piece::jet(double u) const {
    const auto stride = static_cast<std::size_t>(width());
    Jet jet{Point(width()), Point(width()), Point(width()), std::nullopt};
    const auto count = static_cast<std::size_t>(degree) + 1;
    const double d = degree;
    // Most curves are of low degree: their rungs need no allocation.
    std::array<double, 32> few{};
    std::vector<double> many(count > few.size() ? count : 0);
    const auto rungs = many.empty() ? std::span(few).first(count) : std::span(many);
    for (int c = 0; c < width(); ++c) {
        for (std::size_t i = 0; i < count; ++i) {
            rungs[i] = coordinates[i * stride + static_cast<std::size_t>(c)];
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
    if (form == Form::rational) {
        jet = projected(jet);
    }
    jet.curvature = curvatureOf(jet.first, jet.second);
    return jet;
}

Pieces::Pieces(int degree, int dimension, KnotLine knots, std::vector<double> bezier, Form form)
    : degree_(degree), dimension_(dimension), form_(form), knots_(std::move(knots)),
      bezier_(std::move(bezier)) {}

Piece Pieces::operator[](std::size_t segment) const {
    Piece piece{{}, degree_, dimension_, form_};
    const auto length = static_cast<std::size_t>((degree_ + 1) * piece.width());
    piece.coordinates = std::span(bezier_).subspan(segment * length, length);
    return piece;
}

Pieces Pieces::part(const Range& range) const {
    if (range.size() == 0) {
        return {degree_, dimension_, {}, {}, form_};
    }
    const auto length = (*this)[0].coordinates.size();
    const auto knots = knots_.knots().subspan(range.first, range.size() + 1);
    const auto numbers = bezier().subspan(range.first * length, range.size() * length);
    return {degree_,
            dimension_,
            KnotLine({knots.begin(), knots.end()}),
            {numbers.begin(), numbers.end()},
            form_};
}

void Pieces::overwrite(std::size_t first, std::span<const double> bezier) {
    const auto start = first * (*this)[first].coordinates.size();
    std::ranges::copy(bezier, bezier_.begin() + static_cast<std::ptrdiff_t>(start));
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
                         std::vector<Blend> bezier, Form form)
    : degree_(degree), controlPoints_(controlPoints), knots_(std::move(knots)),
      bezier_(std::move(bezier)) {
    for (std::size_t i = 0; form == Form::rational && i < bezier_.size(); ++i) {
        const double weight = bezier_[i].sumBelow(controlPoints_);
        weights_.push_back(weight);
        bezier_[i] = (1 / weight) * bezier_[i];
    }
}

std::span<const Blend> BlendPieces::operator[](std::size_t segment) const {
    const auto count = static_cast<std::size_t>(degree_) + 1;
    return std::span(bezier_).subspan(segment * count, count);
}

std::span<const double> BlendPieces::weights(std::size_t segment) const {
    const auto count = static_cast<std::size_t>(degree_) + 1;
    return weights_.empty() ? std::span<const double>()
                            : std::span(weights_).subspan(segment * count, count);
}

Blend BlendPieces::basis(Spot spot) const {
    const auto bezier = (*this)[spot.segment];
    const auto weights = this->weights(spot.segment);
    std::vector<Blend> rungs(bezier.begin(), bezier.end());
    for (std::size_t k = 0; k < weights.size(); ++k) {
        rungs[k] = weights[k] * rungs[k];
    }
    for (std::size_t left = rungs.size(); left > 1; --left) {
        climb(std::span(rungs).first(left), spot.u);
    }
    const Blend& tip = rungs.front();
    return weights.empty() ? tip : (1 / tip.sumBelow(controlPoints_)) * tip;
}

} // namespace splineloft
