// The inverse of lengths along a curve, compiled for every set of instructions.
#pragma once

#include <array>
#include <cstddef>

namespace splineloft::lanes {

/// The length s(x) from the start of a panel, -1 <= x <= 1, and where to begin to seek x.
struct LengthSeries {
    static constexpr std::size_t count = 16;

    std::array<double, count + 1> lengths{}; ///< powers of x
    std::array<double, count> speeds{};      ///< powers of x: the derivative
    std::array<double, 6> start{}; ///< x(s), about: Newton's divided differences over the lengths
                                   ///< 0, 0, middle, middle, whole, whole
    double middle = 0;             ///< length at x = 0
    double whole = 0;              ///< length at x = 1
};

/// The values of x at which `count` lengths are reached, which replace them: steps of third order
/// from the start. The speed must be well above zero everywhere.
void invertLengths(const LengthSeries& series, double* lengths, std::size_t count);

} // namespace splineloft::lanes
