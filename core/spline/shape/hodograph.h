// The hodograph: the curve that the derivative draws.
#pragma once

#include "core/spline/piece.h"

namespace splineloft {

/// The derivative by u of every piece, over the same knots, as pieces again: of degree d - 1 (but
/// at least 0) from polynomial pieces of degree d, with Bézier points d (P[i+1] - P[i]) (Hamilton
/// 1846); of degree 2d from rational ones, by the quotient rule. Unit: length by 1.
Pieces hodograph(const Pieces& pieces);

/// The same of one piece, over the knots 0 and 1.
Pieces hodograph(const Piece& piece);

} // namespace splineloft
