// The passes over all points in which a natural spline is built, compiled for every set of
// instructions.
#pragma once

#include <cstddef>

namespace splineloft::lanes {

/// What there is to know of points (x, y) before a spline goes through them.
struct Survey {
    bool rises = false; ///< each x is above the one before; then none but the ends is infinite
    double leastInterval = 0; ///< of x; only where it rises
    bool isModest = false;    ///< every y is a number, smaller than `most` in size
};
Survey surveyOf(const double* x, const double* y, std::size_t count, double most);

/// Intervals and slopes of the chords between `pieces` + 1 points.
void measureChords(const double* x, const double* y, std::size_t pieces, double* intervals,
                   double* chords);

/// Diagonal and right side of `rows` equations from the rows + 1 intervals and chords around them:
/// 2 (h[k] + h[k+1]) and 3 (h[k+1] s[k] + h[k] s[k+1]).
void formSlopeRows(const double* intervals, const double* chords, std::size_t rows,
                   double* diagonal, double* right);

} // namespace splineloft::lanes
