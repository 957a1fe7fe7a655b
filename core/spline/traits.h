// What kind of curve this is, measured on its blends and joints and never declared.
#pragma once

#include "core/spline/continuity.h"
#include "core/spline/curve.h"

#include <vector>

namespace splineloft {

/// Properties of one curve as it stands.
struct Traits {
    std::vector<bool> onCurve; ///< for each control point, whether the curve passes through it
    bool throughAll = false;   ///< it does for all of them
    bool throughEnds = false;  ///< it starts at the first control point and ends at the last
    bool affine = false;       ///< weights sum to 1: moving the points moves the curve with them
    bool inHull = false;       ///< weights are never negative: the curve stays in the convex hull
    bool global = false;       ///< every control point moves every piece, however little
    std::size_t reach = 0;     ///< most pieces that one control point moves
    std::vector<Joint> joints;
    int c = 2, g = 2; ///< the least continuity of any joint
};

/// Measures a curve from its pieces and their blends.
Traits traitsOf(const Curve& curve, const Pieces& pieces, const BlendPieces& blends);

} // namespace splineloft
