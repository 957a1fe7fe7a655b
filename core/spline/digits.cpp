#include "core/spline/digits.h"

#include <array>
#include <charconv>
#include <cmath>

namespace splineloft {
namespace {

/// What std::to_chars writes of the value with this format, if any.
template <class... Format> std::string written(double value, Format... format) {
    std::array<char, 32> text{};
    return {text.data(),
            std::to_chars(text.data(), text.data() + text.size(), value, format...).ptr};
}

} // namespace

std::string allDigits(double value) {
    return written(value);
}

std::string twoDigits(double value) {
    return written(value, std::chars_format::general, 2);
}

std::string threeDigits(double value) {
    const bool large = std::abs(value) >= 1000 && std::abs(value) < 1e6;
    return large ? written(value, std::chars_format::fixed, 0)
                 : written(value, std::chars_format::general, 3);
}

} // namespace splineloft
