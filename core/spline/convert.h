// The same curve as another family, where that exists exactly.
#pragma once

#include "core/spline/problem.h"

#include <variant>
#include <vector>

namespace splineloft {

/// The Bézier points of the same piece as one of a degree not below its own. Exact but for rounding
/// (Forrest 1972).
std::vector<Point> elevated(const Piece& piece, int degree);

/// The curve, piece for piece the same points at the same u, as one of another family:
/// `bezier-spline` for all whose degree is at most 3, `hermite` where besides the derivatives by u
/// agree at the joints, `bezier` for a single piece, `linear` for straight ones. Knots that are not
/// whole numbers are lost: the path is the same, its parameter is not. A problem where there is no
/// such curve, saying why.
std::variant<Curve, Problem> converted(const Curve& curve, std::string_view family);

} // namespace splineloft
