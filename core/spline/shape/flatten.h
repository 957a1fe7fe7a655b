// A curve as a chain of straight lines.
#pragma once

#include "core/spline/piece.h"

#include <cstddef>
#include <vector>

namespace splineloft {

/// A chain of chords: the lines from the place of each spot to the next.
struct Polyline {
    std::vector<Spot> spots;
    /// Whether no place of the curve is farther from the chain, nor of the chain from the curve,
    /// than was asked. If not, the spots were spread evenly.
    bool withinTolerance = false;
};

/// More spots than a screen has pixels.
inline constexpr std::size_t mostFlatSpots = 100'000;

/// The curve within `tolerance` (a length), in any dimension. The spots include all joints; those
/// between are as few as steps as long as possible need. Each step is checked: its own Bézier
/// points are nowhere so far from the chord that the curve could be farther than the tolerance.
/// Where that would take more than `most` spots (but at least 2), and where the tolerance is finer
/// than rounding, as 0 and NaN are for anything bent, `most` spots or fewer are spread evenly over
/// the pieces. Work is bounded by a multiple of `most`. No spots where there is no piece. (The
/// steps' first guess is that the distance grows with the square of the step, as in Wang 1984.)
Polyline flattened(const Pieces& pieces, double tolerance, std::size_t most = mostFlatSpots);

} // namespace splineloft
