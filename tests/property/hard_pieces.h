// Pieces that are hard to measure and to find the way to: of any degree, dimension and form, with
// cusps, rests and legs there and back. All from a seed.
#pragma once

#include "core/spline/piece.h"
#include "tests/property/random_curves.h"
#include "tests/property/random_pieces.h"

#include <vector>

namespace splineloft::testing_curves {

/// One piece over the knots 0 and 1.
Pieces onePiece(int degree, int dimension, std::vector<double> bezier,
                splineloft::Form form = splineloft::Form::polynomial);

/// A polynomial piece; some of its Bézier points coincide or lie on a line.
Pieces randomPolynomial(Dice& dice, int degree, int dimension);
/// A rational piece with weights between 1/8 and 8.
Pieces randomRational(Dice& dice, int degree, int dimension);
/// A cubic that all but stops somewhere, or does.
Pieces nearlyCuspedCubic(Dice& dice, int dimension);
/// Any of these: degrees to 9, dimensions to 5.
Pieces randomPiece(Dice& dice);
/// A row of cubics in the plane or in space, one beginning where the other ends.
Pieces randomRow(Dice& dice, int pieces);

/// The exact circle around `center` as four rational quadratic pieces.
Pieces circle(const Point& center, double radius);
/// The same piece as two.
Pieces splitAt(const Piece& piece, double u);
/// The same pieces in a space of four dimensions.
Pieces inFourDimensions(const Pieces& pieces);
/// The same polynomial pieces in rational form.
Pieces withWeightsOfOne(const Pieces& pieces);

} // namespace splineloft::testing_curves
