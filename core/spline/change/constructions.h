// The textbook constructions of a point, as values to be drawn: levels of points, each on the line
// through two of the level before, until one is left, the point of the curve. The ladder of de
// Casteljau is their cousin on a single piece (ladder.h).
#pragma once

#include "core/spline/problem.h"

#include <variant>
#include <vector>

namespace splineloft {

/// A point of a construction. Above level 0 it lies on the line through rungs number i and i + 1 of
/// the level before: at the former for t = `from`, at the latter for t = `to`, beyond them outside.
struct Rung {
    Point place;
    double from = 0, to = 0; ///< parameter values
};

/// Levels of rungs, each with one fewer than the one before; level 0 are control points, the last
/// is a single rung at the point of the curve.
struct Construction {
    std::vector<std::vector<Rung>> levels;
    const Point& tip() const { return levels.back().front().place; }
};

/// de Boor's triangle at parameter value t, moved into the curve, of b-spline and nurbs (de Boor
/// 1972). Of level 0 are the degree + 1 control points that pull there, each with the interval of
/// the parameter over which it pulls. On a rational curve the points are the projections, which lie
/// on the same lines, though not in proportion to t.
std::variant<Construction, Problem> deBoor(const Curve& curve, double t);

/// Barry and Goldman's pyramid of catmull-rom, of any alpha (1988): four control points, each at
/// its own knot (from = to), then lines through two, parabolas through three, and between the
/// middle two knots the blend of both. A line between points that coincide has no interval: it
/// stays at the one nearer to the piece.
std::variant<Construction, Problem> barryGoldman(const Curve& curve, Spot spot);

/// Neville's pyramid of lagrange (Aitken 1932, Neville 1934): level r has the polynomials of degree
/// r through r + 1 points in a row, the first of which stand at t = `from` and `to`.
std::variant<Construction, Problem> neville(const Curve& curve, double t);

} // namespace splineloft
