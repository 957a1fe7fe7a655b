// Pieces for testing operations on them: of every degree, polynomial and rational.
#pragma once

#include "core/spline/piece.h"

#include "tests/property/random_curves.h"

#include <vector>

namespace splineloft::testing_curves {

/// Pieces over the knots 0, 1, 2, ... through these Bézier points, each piece starting with the
/// last point of the one before: degree * pieces + 1 points. With weights (as many), rational.
Pieces chainOf(int degree, const std::vector<Point>& points,
               const std::vector<double>& weights = {});

/// One piece through all of the points.
Pieces pieceOf(const std::vector<Point>& points, const std::vector<double>& weights = {});

/// What `randomPieces` may come up with.
struct Variety {
    int dimension = 2;
    int mostDegree = 6;
    int mostPieces = 4;
    double offset = 1000; ///< how far from the origin
    double extent = 8;    ///< how far around
};

/// Pieces of random degree, form, number and uneven knots.
Pieces randomPieces(Dice& dice, const Variety& variety);

/// Degree, form, knots and Bézier points, to see which ones failed.
std::string wordsOf(const Pieces& pieces);

/// The largest absolute coordinate of the Bézier points.
double farthest(const Pieces& pieces);
/// The longest side of the box around the Bézier points.
double extentOf(const Pieces& pieces);

} // namespace splineloft::testing_curves
