// Numbers without the dust that decimals leave behind when they are added in binary.
#pragma once

#include <array>
#include <charconv>

namespace splineloft {

/// The value to 14 significant digits.
inline double tidied(double value) {
    std::array<char, 40> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value,
                                   std::chars_format::scientific, 13)
                         .ptr;
    double result = 0;
    std::from_chars(text.data(), end, result);
    return result;
}

/// a + b to 14 significant digits; a itself where b is nothing.
inline double cleanSum(double a, double b) {
    return b == 0 ? a : tidied(a + b);
}

} // namespace splineloft
