#include "tests/property/hard_pieces.h"

#include <cmath>
#include <numbers>

namespace splineloft::testing_curves {
namespace {

KnotLine knotsOf(std::size_t pieces) {
    std::vector<double> knots;
    for (std::size_t i = 0; i <= pieces; ++i) {
        knots.push_back(static_cast<double>(i));
    }
    return KnotLine(std::move(knots));
}

} // namespace

Pieces onePiece(int degree, int dimension, std::vector<double> bezier, Form form) {
    return {degree, dimension, knotsOf(1), std::move(bezier), form};
}

Pieces randomPolynomial(Dice& dice, int degree, int dimension) {
    std::vector<double> bezier;
    const Point center = dice.pointOnGrid(dimension, dice.oneIn(2) ? 1 : 100);
    const bool isLine = dice.oneIn(8);
    const Point along = dice.pointOnGrid(dimension, 4);
    for (int i = 0; i <= degree; ++i) {
        if (i > 0 && dice.oneIn(10)) { // as the one before
            const std::vector<double> before(bezier.end() - dimension, bezier.end());
            bezier.insert(bezier.end(), before.begin(), before.end());
            continue;
        }
        const Point place =
            center + (isLine ? dice.onGrid(2) * along : dice.pointOnGrid(dimension, 4));
        bezier.insert(bezier.end(), place.coordinates().begin(), place.coordinates().end());
    }
    return onePiece(degree, dimension, std::move(bezier));
}

Pieces randomRational(Dice& dice, int degree, int dimension) {
    const Pieces flat = randomPolynomial(dice, degree, dimension);
    std::vector<double> bezier;
    for (int i = 0; i <= degree; ++i) {
        const double weight = std::exp2(dice.between(-3, 3));
        const Point place = weight * flat[0].bezierPoint(i);
        bezier.insert(bezier.end(), place.coordinates().begin(), place.coordinates().end());
        bezier.push_back(weight);
    }
    return onePiece(degree, dimension, std::move(bezier), splineloft::Form::rational);
}

Pieces nearlyCuspedCubic(Dice& dice, int dimension) {
    // The hodograph (u - r) (a + b u) and a little, integrated from a random place.
    const double r = dice.between(-0.2, 1.2);
    const double rest = dice.oneIn(6) ? 0 : std::exp2(dice.between(-40, 0));
    const Point a = dice.pointOnGrid(dimension, 2);
    const Point b = dice.oneIn(4) ? -1 / (r + 1e-3) * a : dice.pointOnGrid(dimension, 2);
    const Point c0 = -r * a + rest * dice.pointOnGrid(dimension, 1);
    const Point c1 = a - r * b;
    const Point c2 = b;
    Point place = dice.pointOnGrid(dimension, 3);
    std::vector<double> bezier;
    const auto add = [&] {
        bezier.insert(bezier.end(), place.coordinates().begin(), place.coordinates().end());
    };
    add();
    for (const auto& leg : {c0, c0 + 0.5 * c1, c0 + c1 + c2}) {
        place += 1.0 / 3 * leg;
        add();
    }
    return onePiece(3, dimension, std::move(bezier));
}

Pieces randomPiece(Dice& dice) {
    switch (dice.whole(0, 3)) {
    case 0: return nearlyCuspedCubic(dice, dice.whole(1, 4));
    case 1: return randomPolynomial(dice, 3, dice.whole(1, 3));
    case 2: return randomPolynomial(dice, dice.whole(1, 9), dice.whole(1, 5));
    default: return randomRational(dice, dice.whole(1, 5), dice.whole(1, 3));
    }
}

Pieces randomRow(Dice& dice, int pieces) {
    const int dimension = dice.whole(2, 3);
    std::vector<double> bezier;
    Point at = dice.pointOnGrid(dimension, 10);
    for (int i = 0; i < pieces; ++i) {
        const Pieces one = dice.oneIn(3) ? nearlyCuspedCubic(dice, dimension)
                                         : randomPolynomial(dice, 3, dimension);
        const Point move = at - one[0].bezierPoint(0);
        for (int k = 0; k <= 3; ++k) {
            at = one[0].bezierPoint(k) + move;
            bezier.insert(bezier.end(), at.coordinates().begin(), at.coordinates().end());
        }
    }
    return {3, dimension, knotsOf(static_cast<std::size_t>(pieces)), std::move(bezier)};
}

Pieces circle(const Point& center, double radius) {
    const double half = std::numbers::sqrt2 / 2;
    const std::vector<Point> corners = {{1, 0},   {1, 1},  {0, 1},  {-1, 1}, {-1, 0},
                                        {-1, -1}, {0, -1}, {1, -1}, {1, 0}};
    std::vector<double> bezier;
    for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
            const double weight = k == 1 ? half : 1;
            const Point place = weight * (center + radius * corners[2 * i + k]);
            bezier.insert(bezier.end(), {place[0], place[1], weight});
        }
    }
    return {2, 2, knotsOf(4), std::move(bezier), splineloft::Form::rational};
}

Pieces splitAt(const Piece& piece, double u) {
    const auto width = static_cast<std::size_t>(piece.width());
    std::vector<double> right(piece.coordinates.begin(), piece.coordinates.end());
    std::vector<double> both;
    for (auto size = right.size(); size > 0; size -= width) {
        both.insert(both.end(), right.begin(), right.begin() + piece.width());
        for (std::size_t i = 0; i + width < size; ++i) {
            right[i] += u * (right[i + width] - right[i]);
        }
    }
    both.insert(both.end(), right.begin(), right.end());
    return {piece.degree, piece.dimension, knotsOf(2), std::move(both), piece.form};
}

Pieces inFourDimensions(const Pieces& pieces) {
    std::vector<double> bezier;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        for (int k = 0; k <= pieces.degree(); ++k) {
            const Point place = pieces[i].bezierPoint(k);
            for (int c = 0; c < 4; ++c) {
                bezier.push_back(c < place.dimension() ? place[c] : 7);
            }
        }
    }
    return {pieces.degree(), 4, pieces.knots(), std::move(bezier)};
}

Pieces withWeightsOfOne(const Pieces& pieces) {
    std::vector<double> bezier;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        for (int k = 0; k <= pieces.degree(); ++k) {
            const Point place = pieces[i].bezierPoint(k);
            bezier.insert(bezier.end(), place.coordinates().begin(), place.coordinates().end());
            bezier.push_back(1);
        }
    }
    return {pieces.degree(), pieces.dimension(), pieces.knots(), std::move(bezier),
            splineloft::Form::rational};
}

} // namespace splineloft::testing_curves
