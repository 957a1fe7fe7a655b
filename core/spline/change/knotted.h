// Pieces as a B-spline. Its control points are the blossoms of the pieces at its knots: whatever
// piece a point pulls on, its blossom at the knots of that point is the point (Ramshaw 1987).
#pragma once

#include "core/spline/curve.h"

#include <optional>
#include <span>
#include <vector>

namespace splineloft::conversion {

/// The knots of a B-spline in the making: where its pieces meet, and how often each knot stands
/// there. A closed one has the first joint again as the last, whose count is not looked at.
struct JointKnots {
    std::vector<double> at; ///< rising
    std::vector<int> times; ///< above zero, at most degree + 1
};

/// How often a curve with knots of its own has this one; on a closed one across its seam, too.
std::size_t timesOf(const Curve& curve, double knot);

/// Knots that stand as often as the smoothness of the pieces asks, which is measured: 1 where all
/// derivatives below the degree are continuous, degree + 1 at a gap and at free ends.
JointKnots knotsNeeded(const Pieces& pieces, bool closed, double tolerance);

/// Those of the Bézier points themselves: degree times at each joint.
JointKnots knotsOfBezierPoints(const Pieces& pieces, bool closed);

/// `blank`, which is of the family b-spline or nurbs, with control points and with these knots of
/// its own, degree + 1 times at free ends. Nothing where a weight would not be above zero.
std::optional<Curve> knotted(const Pieces& pieces, const JointKnots& knots, Curve blank);

/// `blank` with the control points of uniform knots, of which an open one has `degree` more beyond
/// either end.
std::optional<Curve> uniformlyKnotted(const Pieces& pieces, Curve blank);

} // namespace splineloft::conversion
