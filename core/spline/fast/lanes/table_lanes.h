// The arguments of Horner's scheme for many u, compiled for every set of instructions. On one piece
// of a high degree they would otherwise be half of the work.
#pragma once

#include <cstddef>

namespace splineloft::lanes {

/// Numbers that may be read and written beyond those asked for.
inline constexpr std::size_t tablePadding = 64;

/// r = u / (1 - u) and (1 - u)^degree for u = k / steps, where k = first, first + direction, ...
struct RatioTable {
    int degree = 0;
    double steps = 0, first = 0, direction = 1;
    std::size_t count = 0;
};
void fillRatios(const RatioTable& table, double* ratios, double* scales);

/// The same for any u: turns each into the ratio as seen from the nearer end, writes the factor,
/// and 1 where that end is u = 1, otherwise 0.
void seeFromNearerEnd(int degree, std::size_t count, double* u, double* scales, double* fromEnd);

} // namespace splineloft::lanes
