// The same curve as another family, where that exists exactly.
#pragma once

#include "core/spline/problem.h"

#include <optional>
#include <variant>
#include <vector>

namespace splineloft {

/// The Bézier points of the same piece as one of a degree not below its own; of a rational piece in
/// homogeneous coordinates, the weight last. Exact but for rounding (Forrest 1972).
std::vector<Point> elevated(const Piece& piece, int degree);

/// How far apart two rows of pieces are, one beside the other at the same u.
struct Difference {
    double most = 0;           ///< the farthest that corresponding Bézier points are apart
    bool sameParameter = true; ///< the knots are the same, up to where t begins and its unit
};

/// The difference of the pieces; nothing where they are not as many, or in other dimensions.
std::optional<Difference> differenceOf(const Pieces& one, const Pieces& other);

/// The curve as one of another family of the catalog, where one exists that is the same curve.
///
/// What is kept: piece for piece the same places at the same u, to 1e-12 of the curve's extent and
/// the rounding of its coordinates; name, names of the coordinates, and whether it is closed. The
/// parameter t is kept, up to where it begins and its unit, by b-spline and nurbs, which may have
/// any knots, and by the others where they have knots like that: families with joints at whole
/// numbers keep only u of a curve whose intervals differ. (`differenceOf` tells.)
///
/// What is found: parameters are read off the pieces, whatever family they came from; the first of
/// doubled, reflected and open ends that gives the curve; values at each control point where one
/// for all does not do (cardinal, kochanek-bartels). B-spline and NURBS are of the pieces' own
/// degree, above 3 without what they were elevated by; uniform where the curve is, otherwise with
/// knots that stand as often as its smoothness asks. Weights that are equal on each piece are left
/// out; other weights only NURBS keep.
///
/// A problem where there is no such curve, saying how far the nearest one would be off and where,
/// with a remedy that names a family that works; or where `curve` itself has one.
std::variant<Curve, Problem> converted(const Curve& curve, std::string_view family);

} // namespace splineloft
