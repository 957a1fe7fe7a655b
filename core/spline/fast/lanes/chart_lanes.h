// Lengths along a curve as series, and their inverse, compiled for every set of instructions.
#pragma once

#include "core/spline/fast/lanes/speed_lanes.h"

#include <array>
#include <cstddef>

namespace splineloft::lanes {

/// Eight times eight numbers, column after column.
using EightByEight = std::array<Eight, 8>;

/// `even` times the sums of the pairs, `odd` times their differences.
void weighPairs(const EightByEight& even, const EightByEight& odd, const EightPairs& pairs,
                Eight& ofSums, Eight& ofDifferences);

/// The length s(x) from the start of a panel, -1 <= x <= 1, and where to begin to seek x.
struct LengthSeries {
    Eight evenSpeed, oddSpeed;     ///< s'(x): powers 0, 2 to 14 of x, and 1, 3 to 15
    Eight oddLength, evenLength;   ///< s(x): powers 1, 3 to 15, and 2, 4 to 16
    double middle = 0;             ///< s(0)
    double whole = 0;              ///< s(1)
    std::array<double, 6> start{}; ///< x(s), about: Newton's divided differences over the lengths
                                   ///< 0, 0, middle, middle, whole, whole
};

/// Speeds at the ends of a panel, x = -1 and x = 1.
struct EndSpeeds {
    double before, after;
};

/// Fills in all but the start, from the Legendre coefficients of the speed: of even orders, and of
/// odd ones. `evenPowers` and `oddPowers` make powers of these.
EndSpeeds integrateSeries(const EightByEight& evenPowers, const EightByEight& oddPowers,
                          const Eight& even, const Eight& odd, LengthSeries& series);

/// How a panel lies on its curve.
struct PanelPlace {
    double lengthBefore = 0; ///< of the curve, to its start
    double toSeries = 1;     ///< what lengths are multiplied by to be those of the series
    double start = 0, end = 1;
};

/// Puts in the place of `count` lengths of a curve the parameters where it reaches them, by
/// Newton's method from the start. The speed must be well above zero everywhere.
void invertLengths(const LengthSeries& series, const PanelPlace& place, double* lengths,
                   std::size_t count);

} // namespace splineloft::lanes
