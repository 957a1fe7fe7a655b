#include "tests/property/random_pieces.h"

#include "core/spline/measure/bounds.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace splineloft::testing_curves {
namespace {

Pieces chainOver(std::vector<double> knots, int degree, const std::vector<Point>& points,
                 const std::vector<double>& weights) {
    const auto d = static_cast<std::size_t>(degree);
    std::vector<double> bezier;
    for (std::size_t first = 0; first + d < points.size(); first += d) {
        for (std::size_t i = first; i <= first + d; ++i) {
            const double weight = weights.empty() ? 1 : weights[i];
            for (const double x : points[i].coordinates()) {
                bezier.push_back(weight * x);
            }
            if (!weights.empty()) {
                bezier.push_back(weight);
            }
        }
    }
    return {degree, points.front().dimension(), KnotLine(std::move(knots)), std::move(bezier),
            weights.empty() ? splineloft::Form::polynomial : splineloft::Form::rational};
}

} // namespace

Pieces chainOf(int degree, const std::vector<Point>& points, const std::vector<double>& weights) {
    std::vector<double> knots;
    for (std::size_t i = 0; i <= (points.size() - 1) / static_cast<std::size_t>(degree); ++i) {
        knots.push_back(static_cast<double>(i));
    }
    return chainOver(std::move(knots), degree, points, weights);
}

Pieces pieceOf(const std::vector<Point>& points, const std::vector<double>& weights) {
    return chainOf(static_cast<int>(points.size()) - 1, points, weights);
}

Pieces randomPieces(Dice& dice, const Variety& variety) {
    const int degree = dice.whole(1, variety.mostDegree);
    const int count = dice.whole(1, variety.mostPieces);
    const bool rational = dice.oneIn(3);
    const Point center = dice.pointOnGrid(variety.dimension, variety.offset);
    std::vector<Point> points;
    std::vector<double> weights;
    for (int i = 0; i <= degree * count; ++i) {
        points.push_back(center + dice.pointOnGrid(variety.dimension, variety.extent));
        if (rational) {
            weights.push_back(std::exp(dice.between(-1.5, 1.5)));
        }
    }
    std::vector<double> knots = {dice.between(-3, 3)};
    for (int i = 0; i < count; ++i) {
        knots.push_back(knots.back() + dice.between(0.1, 2));
    }
    return chainOver(std::move(knots), degree, points, weights);
}

std::string wordsOf(const Pieces& pieces) {
    std::ostringstream words;
    words.precision(17);
    words << "degree " << pieces.degree() << ", "
          << (pieces.form() == splineloft::Form::rational ? "rational" : "polynomial");
    words << ", knots";
    for (const double knot : pieces.knots().knots()) {
        words << ' ' << knot;
    }
    words << ", numbers";
    for (const double x : pieces.bezier()) {
        words << ' ' << x;
    }
    return words.str();
}

double farthest(const Pieces& pieces) {
    double size = 0;
    if (const auto box = hullBox(pieces)) {
        for (int c = 0; c < pieces.dimension(); ++c) {
            size = std::max({size, std::abs(box->low[c]), std::abs(box->high[c])});
        }
    }
    return size;
}

double extentOf(const Pieces& pieces) {
    double size = 0;
    if (const auto box = hullBox(pieces)) {
        for (int c = 0; c < pieces.dimension(); ++c) {
            size = std::max(size, box->high[c] - box->low[c]);
        }
    }
    return size;
}

} // namespace splineloft::testing_curves
