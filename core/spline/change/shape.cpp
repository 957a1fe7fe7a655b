#include "core/spline/change/shape.h"

#include "core/spline/change/convert.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace splineloft::conversion {
namespace {

// Beside the extent of the curve: far below what can be seen, well above what a conversion's own
// arithmetic leaves.
constexpr double partOfExtent = 1e-12;
// Roundings of the farthest coordinate that add up on the way from one family to another.
constexpr double roundings = 64;
// Weights of one piece that differ by less are equal but for rounding.
constexpr double equalWeights = 1e-13;
// Intervals of the knots that differ by less are equal but for rounding.
constexpr double equalIntervals = 1e-12;

/// Calls `visit(place)` with every Bézier point.
template <class Visit> void forEveryPoint(const Pieces& pieces, Visit visit) {
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        for (int k = 0; k <= pieces.degree(); ++k) {
            visit(pieces[i].bezierPoint(k));
        }
    }
}

bool hasEqualWeights(const Piece& piece) {
    for (int k = 1; k <= piece.degree; ++k) {
        if (std::abs(piece.weight(k) - piece.weight(0)) > equalWeights * piece.weight(0)) {
            return false;
        }
    }
    return true;
}

/// All coordinates divided by 2^exponent; each rational piece, whose weights matter only by their
/// ratios, with the weight at its start that the one before has at its end.
Pieces scaled(const Pieces& pieces, int exponent) {
    const int dimension = pieces.dimension();
    std::vector<double> bezier(pieces.bezier().begin(), pieces.bezier().end());
    const int width = pieces.empty() ? dimension : pieces[0].width();
    const auto perPiece = static_cast<std::size_t>((pieces.degree() + 1) * width);
    double weight = pieces.empty() ? 1 : pieces[0].weight(0);
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const double factor = weight / pieces[i].weight(0);
        for (std::size_t k = 0; k < perPiece; ++k) {
            const bool isWeight = static_cast<int>(k) % width == dimension;
            double& number = bezier[i * perPiece + k];
            number = factor * (isWeight ? number : std::scalbn(number, -exponent));
        }
        weight = factor * pieces[i].weight(pieces.degree());
    }
    return {pieces.degree(), dimension, pieces.knots(), std::move(bezier), pieces.form()};
}

/// One degree less: from the first point onward for the first half, from the last one backward for
/// the other, so that rounding does not build up.
std::vector<double> loweredOnce(std::span<const double> points, std::size_t degree,
                                std::size_t width) {
    std::vector<double> low(degree * width);
    const auto d = static_cast<double>(degree);
    const std::size_t half = (degree + 1) / 2;
    for (std::size_t c = 0; c < width; ++c) {
        for (std::size_t k = 0; k < half; ++k) {
            const auto j = static_cast<double>(k);
            const double before = k > 0 ? low[(k - 1) * width + c] : 0;
            low[k * width + c] = (d * points[k * width + c] - j * before) / (d - j);
        }
        for (std::size_t k = degree; k > half; --k) {
            const auto j = static_cast<double>(k);
            const double after = k < degree ? low[k * width + c] : 0;
            low[(k - 1) * width + c] = (d * points[k * width + c] - (d - j) * after) / j;
        }
    }
    return low;
}

} // namespace

Pieces withoutIdleWeights(const Pieces& pieces) {
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        if (!hasEqualWeights(pieces[i])) {
            return pieces;
        }
    }
    std::vector<double> bezier;
    forEveryPoint(pieces, [&](const Point& place) {
        bezier.insert(bezier.end(), place.coordinates().begin(), place.coordinates().end());
    });
    return {pieces.degree(), pieces.dimension(), pieces.knots(), std::move(bezier)};
}

double toleranceOf(const Pieces& pieces) {
    double farthest = 0;
    Point low(pieces.dimension());
    Point high = low;
    bool first = true;
    forEveryPoint(pieces, [&](const Point& place) {
        for (int c = 0; c < pieces.dimension(); ++c) {
            low[c] = first ? place[c] : std::min(low[c], place[c]);
            high[c] = first ? place[c] : std::max(high[c], place[c]);
            farthest = std::max(farthest, std::abs(place[c]));
        }
        first = false;
    });
    return partOfExtent * distance(low, high) +
           roundings * std::numeric_limits<double>::epsilon() * farthest;
}

Point Shape::joint(std::size_t i) const {
    return i < size() ? pieces[i].bezierPoint(0) : pieces[i - 1].bezierPoint(pieces.degree());
}

Point Shape::leaving(std::size_t joint) const {
    return joint < size() ? pieces.jet({joint, 0}).first : pieces.jet({joint - 1, 1}).first;
}

Point Shape::arriving(std::size_t joint) const {
    return isInner(joint) || joint > 0 ? pieces.jet({(joint + size() - 1) % size(), 1}).first
                                       : pieces.jet({0, 0}).first;
}

bool Shape::isUniform() const {
    const auto& knots = pieces.knots();
    const double mean = (knots.end() - knots.start()) / static_cast<double>(size());
    for (std::size_t i = 0; i < size(); ++i) {
        if (!(std::abs(knots.interval(i) - mean) <= equalIntervals * std::abs(mean))) {
            return false;
        }
    }
    return mean > 0;
}

Shape shapeOf(const Pieces& pieces, bool closed) {
    double farthest = 0;
    forEveryPoint(pieces, [&](const Point& place) {
        for (const double x : place.coordinates()) {
            farthest = std::max(farthest, std::abs(x));
        }
    });
    Shape shape;
    shape.closed = closed;
    shape.exponent = farthest > 0 ? std::ilogb(farthest) : 0;
    shape.pieces = scaled(withoutIdleWeights(pieces), shape.exponent);
    shape.tolerance = toleranceOf(shape.pieces);
    return shape;
}

Point homogeneous(const Piece& piece, int index) {
    const auto width = static_cast<std::size_t>(piece.width());
    return Point(piece.coordinates.subspan(static_cast<std::size_t>(index) * width, width));
}

Pieces raised(const Pieces& pieces, int degree) {
    std::vector<double> bezier;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        for (const auto& point : elevated(pieces[i], degree)) {
            const auto row = point.coordinates();
            bezier.insert(bezier.end(), row.begin(), row.end());
        }
    }
    return {degree, pieces.dimension(), pieces.knots(), std::move(bezier), pieces.form()};
}

std::optional<Pieces> lowered(const Pieces& pieces, int degree, double tolerance) {
    std::vector<double> bezier;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const Piece piece = pieces[i];
        const auto width = static_cast<std::size_t>(piece.width());
        std::vector<double> points(piece.coordinates.begin(), piece.coordinates.end());
        for (int d = pieces.degree(); d > degree; --d) {
            points = loweredOnce(points, static_cast<std::size_t>(d), width);
        }
        const auto back = elevated({points, degree, piece.dimension, piece.form}, piece.degree);
        for (int k = 0; k <= piece.degree; ++k) {
            if (!(distance(back[static_cast<std::size_t>(k)], homogeneous(piece, k)) <=
                  tolerance)) {
                return std::nullopt;
            }
        }
        bezier.insert(bezier.end(), points.begin(), points.end());
    }
    return Pieces(degree, pieces.dimension(), pieces.knots(), std::move(bezier), pieces.form());
}

std::optional<Pieces> ofDegree(const Pieces& pieces, int degree, double tolerance) {
    if (pieces.degree() == degree) {
        return pieces;
    }
    return pieces.degree() < degree ? raised(pieces, degree) : lowered(pieces, degree, tolerance);
}

} // namespace splineloft::conversion
