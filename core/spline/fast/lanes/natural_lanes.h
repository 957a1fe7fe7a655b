// What points must be before a natural spline goes through them, compiled for every set of
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

} // namespace splineloft::lanes
