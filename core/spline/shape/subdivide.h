// Cutting curves: by de Casteljau's ladder, whose left and right sides are the Bézier points of the
// two halves (de Casteljau 1959; Lane and Riesenfeld 1980). The curve stays where it was.
#pragma once

#include "core/spline/piece.h"

#include <span>
#include <vector>

namespace splineloft {

/// The two halves of a piece, each as `Piece::coordinates` of the whole piece's degree and form.
struct Halves {
    std::vector<double> before, after;
};

/// Cuts a piece at u. Each half is run through by its own u from 0 to 1.
Halves halved(const Piece& piece, double u);

/// The Bézier points of the stretch of a piece from one u to another, 0 <= from <= to <= 1.
std::vector<double> stretchOf(const Piece& piece, double from, double to);

/// The same curve with one more piece: that of the spot becomes two, with a knot at the spot's
/// parameter. At a joint there is nothing to cut, and the curve is returned as it is. Spots outside
/// of the curve count as its nearer end. O(pieces).
Pieces subdivided(const Pieces& pieces, Spot spot);

/// The curve from one spot to another, over the knots between: it has the same parameter values.
/// No pieces where `to` does not come after `from`.
Pieces part(const Pieces& pieces, Spot from, Spot to);

/// The curve run through backwards: the knots keep their first, their last, and their intervals.
Pieces reversed(const Pieces& pieces);

} // namespace splineloft
