// B-splines and their knots: one more of them, all of them in sight, one degree more. The curve
// stays the same curve; it only gets more control points to be changed by.
#pragma once

#include "core/spline/problem.h"

#include <variant>

namespace splineloft {

/// The same b-spline or nurbs curve with knots of its own. The points, weights and knots that its
/// ends add are written out, and an open one has ends `none` (a mirrored point has the weight of
/// the one that it mirrors). The parameter t is kept. A problem for other families.
std::variant<Curve, Problem> withOwnKnots(const Curve& curve);

/// The same curve with `times` more knots at parameter value t, and as many more control points:
/// each lies on a leg of the polygon before (Boehm 1980). The knots are then the curve's own, as
/// `withOwnKnots` writes them; at every other knot nothing changes. t lies within the curve; of a
/// closed one its end is its start. A knot may stand degree + 1 times (at which the curve could be
/// broken), on a closed curve degree times. A problem otherwise, and for families without knots.
std::variant<Curve, Problem> withKnot(const Curve& curve, double t, int times = 1);

/// The same curve, of one degree more. bezier gets one more point (Forrest 1972); of b-spline and
/// nurbs each inner knot stands once more, so that the curve is as smooth there as before, and
/// free ends are clamped (Prautzsch 1984). The parameter t is kept. A problem for other families,
/// which are of one degree only, and beyond the highest degree. Places are kept as
/// by `converted`; where the degree is so high, or the knots so uneven, that rounding would show
/// beyond that, inner knots stand as often as Bézier points take.
std::variant<Curve, Problem> elevated(const Curve& curve);

} // namespace splineloft
