// Lengths along a curve as series, and their inverse, compiled for every set of instructions.
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

/// Eight numbers, and eight times eight, column after column.
using Eight = std::array<double, 8>;
using EightByEight = std::array<Eight, 8>;

/// What makes powers of a function's values at pairs of places +x and -x: first the coefficients of
/// its Legendre series, of these the powers. The even ones are made of the sums of the pairs, the
/// odd ones of the differences.
struct PowerTables {
    EightByEight evenCoefficients, evenPowers, oddCoefficients, oddPowers;
};

/// Fills in the speeds, and of the lengths all but the first, from sums and differences of speeds.
void integrateSpeeds(const PowerTables& tables, const Eight& sums, const Eight& differences,
                     LengthSeries& series);

/// The values of x at which `count` lengths are reached, which replace them: steps of third order
/// from the start. The speed must be well above zero everywhere.
void invertLengths(const LengthSeries& series, double* lengths, std::size_t count);

} // namespace splineloft::lanes
