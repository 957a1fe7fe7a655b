// Some pieces of a curve as a curve of their own, of the same family.
#pragma once

#include "core/spline/curve.h"

#include <optional>

namespace splineloft {

/// `count` pieces of the curve from number `first` on, as an open curve of the same shape; of a
/// closed curve on across its seam. The control points that these pieces read are written out, so
/// that a family whose points pull beyond their neighbours has open ends. Nothing where the family
/// has no such curve, which is measured.
std::optional<Curve> excerpt(const Curve& curve, std::size_t first, std::size_t count);

/// The same open b-spline or nurbs curve with knots of its own that stand degree + 1 times at both
/// ends, so that it begins at its first control point and ends at its last. Nothing where weights
/// or rounding forbid that.
std::optional<Curve> clampedAtEnds(const Curve& curve);

} // namespace splineloft
