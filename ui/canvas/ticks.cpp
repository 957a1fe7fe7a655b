#include "ui/canvas/ticks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace splineloft::ui {
namespace {

std::string raised(int number) {
    static constexpr std::array<const char*, 10> digits = {"⁰", "¹", "²", "³", "⁴",
                                                           "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string text = number < 0 ? "⁻" : "";
    for (const char digit : std::to_string(std::abs(number))) {
        text += digits[static_cast<std::size_t>(digit - '0')];
    }
    return text;
}

} // namespace

double tickStep(double span, double pixels, double apart) {
    constexpr double smallest = std::numeric_limits<double>::min();
    const double least = std::max(span * (apart / std::max(pixels, 1.0)), 10 * smallest);
    const double power = std::pow(10.0, std::floor(std::log10(least)));
    for (const double digit : {1.0, 2.0, 5.0}) {
        if (digit * power >= least * (1 - 1e-12)) {
            return digit * power;
        }
    }
    return 10 * power;
}

Magnitude magnitudeOf(double largest) {
    constexpr double few = 0.01, many = 1e4; // between them numbers are written as they are
    if (!(largest > 0) || (largest >= few && largest < many)) {
        return {};
    }
    const int exponent = 3 * static_cast<int>(std::floor(std::log10(largest) / 3));
    return {std::pow(10.0, exponent), "10" + raised(exponent) + " "};
}

} // namespace splineloft::ui
