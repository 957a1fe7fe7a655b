// Powers of two that bring numbers to a size at which they can be squared.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>

namespace splineloft {

/// The largest size of any of the numbers; 0 of none.
inline double largestOf(std::span<const double> numbers) {
    double largest = 0;
    for (const double x : numbers) {
        largest = std::max(largest, std::abs(x));
    }
    return largest;
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
