// Powers of two that bring numbers to a size at which they can be squared.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>

namespace splineloft {

/// From 1 to the next greater number: what rounding is measured in.
inline constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// The largest size of any of the numbers; 0 of none.
inline double largestOf(std::span<const double> numbers) {
    double largest = 0;
    for (const double x : numbers) {
        largest = std::max(largest, std::abs(x));
    }
    return largest;
}

/// Whether all numbers are at most so large, and none is NaN. As quick as reading them.
inline bool allWithin(std::span<const double> numbers, double most) {
    const auto beyond = [most](double x) { return std::abs(x) <= most ? 0.0 : 1.0; };
    std::array<double, 4> counts{}; // of every fourth number, so that none waits for the others
    std::size_t i = 0;
    for (; i + counts.size() <= numbers.size(); i += counts.size()) {
        for (std::size_t k = 0; k < counts.size(); ++k) {
            counts[k] += beyond(numbers[i + k]);
        }
    }
    for (; i < numbers.size(); ++i) {
        counts[0] += beyond(numbers[i]);
    }
    return counts[0] + counts[1] + counts[2] + counts[3] == 0;
}

/// A power of two by which numbers up to `largest` are multiplied to be squared safely; 1 for all
/// ordinary sizes. Multiplying by it is exact.
inline double scaleFor(double largest) {
    constexpr double safe = 0x1p250;
    if ((largest > 1 / safe && largest < safe) || !(largest > 0)) {
        return 1;
    }
    constexpr int mostExponent = 1000;
    return std::ldexp(1.0, std::clamp(-std::ilogb(largest), -mostExponent, mostExponent));
}

} // namespace splineloft
