// Pieces beside pieces: both in the same degree, Bézier point by Bézier point.
#include "core/spline/change/convert.h"
#include "core/spline/change/shape.h"

#include <algorithm>
#include <cmath>

namespace splineloft {
namespace {

using conversion::homogeneous;

// Knots that differ by less than this part of their line are the same but for rounding.
constexpr double sameKnots = 1e-12;

/// A Bézier point.
struct Weighted {
    Point place;
    double weight = 1;
};

/// The Bézier points of a piece in a degree not below its own.
std::vector<Weighted> pointsOf(const Piece& piece, int degree) {
    std::vector<Weighted> points;
    for (const auto& own : elevated(piece, degree)) {
        const Point first(own.coordinates().first(static_cast<std::size_t>(piece.dimension)));
        if (piece.form == Form::rational) {
            const double weight = own[piece.dimension];
            points.push_back({(1 / weight) * first, weight});
        } else {
            points.push_back({first, 1});
        }
    }
    return points;
}

/// Not std::max, which would pass over what is not a number.
void raiseTo(double& most, double value) {
    most = value <= most ? most : value;
}

/// How far two pieces are apart; weights count by the ratio of their ratios, times the extent.
double apart(const Piece& one, const Piece& other, int degree) {
    const auto a = pointsOf(one, degree);
    const auto b = pointsOf(other, degree);
    double places = 0, weights = 0, extent = 0;
    for (std::size_t k = 0; k < a.size(); ++k) {
        raiseTo(places, distance(a[k].place, b[k].place));
        raiseTo(extent, distance(a[k].place, a[0].place));
        const double ratio = (a[k].weight / a[0].weight) / (b[k].weight / b[0].weight);
        raiseTo(weights, std::abs(ratio - 1));
    }
    raiseTo(places, weights * extent);
    return places;
}

/// Whether the knots lie at the same parts of their lines.
bool haveSameParameter(const KnotLine& one, const KnotLine& other) {
    const auto part = [](const KnotLine& line, std::size_t i) {
        const double whole = line.end() - line.start();
        return whole > 0 ? (line.knots()[i] - line.start()) / whole : 0;
    };
    for (std::size_t i = 0; i <= one.pieces(); ++i) {
        if (!(std::abs(part(one, i) - part(other, i)) <= sameKnots)) {
            return false;
        }
    }
    return true;
}

} // namespace

std::vector<Point> elevated(const Piece& piece, int degree) {
    std::vector<Point> points;
    for (int k = 0; k <= piece.degree; ++k) {
        points.push_back(homogeneous(piece, k));
    }
    for (int d = piece.degree; d < degree; ++d) {
        points.push_back(points.back());
        for (int k = d; k > 0; --k) {
            const auto at = static_cast<std::size_t>(k);
            points[at] = lerp(points[at], points[at - 1], static_cast<double>(k) / (d + 1));
        }
    }
    return points;
}

std::optional<Difference> differenceOf(const Pieces& one, const Pieces& other) {
    if (one.size() != other.size() || one.dimension() != other.dimension() || one.empty()) {
        return std::nullopt;
    }
    const int degree = std::max(one.degree(), other.degree());
    Difference difference;
    for (std::size_t i = 0; i < one.size(); ++i) {
        raiseTo(difference.most, apart(one[i], other[i], degree));
    }
    difference.sameParameter = haveSameParameter(one.knots(), other.knots());
    return difference;
}

} // namespace splineloft
