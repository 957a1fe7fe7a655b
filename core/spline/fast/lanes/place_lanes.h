// Places on one cubic, compiled for every set of instructions.
#pragma once

#include <array>
#include <cstddef>

namespace splineloft::lanes {

/// One coordinate of a cubic, in powers of u and of 1 - u: exact at both ends.
struct CubicFromEnds {
    std::array<double, 4> rise, fall;
};

/// The places of 2 or 3 coordinates at `count` values of u, one after the other.
void placeOnCubic(const std::array<CubicFromEnds, 3>& cubic, std::size_t dimension, const double* u,
                  std::size_t count, double* places);

} // namespace splineloft::lanes
