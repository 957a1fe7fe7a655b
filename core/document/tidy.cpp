#include "core/document/tidy.h"

#include <array>
#include <charconv>
#include <cmath>

namespace splineloft {
namespace {

constexpr int digits = 14;

/// By way of the decimals, which is exact.
double throughDecimals(double value) {
    std::array<char, 40> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value,
                                   std::chars_format::scientific, digits - 1)
                         .ptr;
    double result = 0;
    std::from_chars(text.data(), end, result);
    return result;
}

} // namespace

// For ordinary sizes the decimals need not be written: the digits make a whole number that a double
// holds exactly, and so does it the power of ten that this is divided by. The quotient is then the
// double nearest to the decimal. Where rounding could have crossed a half, the decimals decide.
double tidied(double value) {
    constexpr double leastOrdinary = 1e-8;
    constexpr double mostOrdinary = 1e13;
    constexpr double doubt = 1.0 / 32; // of a unit in the last digit; the product errs by 1 / 128
    static constexpr std::array powers = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                          1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                          1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22}; // all exact
    const double size = std::abs(value);
    if (!(size > leastOrdinary && size < mostOrdinary)) {
        return throughDecimals(value);
    }
    const auto power = powers[static_cast<std::size_t>(digits - 1 - std::floor(std::log10(size)))];
    const double shifted = value * power;
    const double whole = std::round(shifted);
    const bool isDoubtful = std::abs(std::abs(shifted - whole) - 0.5) < doubt;
    const bool hasAllDigits = std::abs(whole) >= 1e13 && std::abs(whole) < 1e14;
    return isDoubtful || !hasAllDigits ? throughDecimals(value) : whole / power;
}

} // namespace splineloft
