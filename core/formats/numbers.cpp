#include "core/formats/numbers.h"

#include <array>
#include <charconv>
#include <cmath>

namespace splineloft {
namespace {

// Outside of this range an exponent is easier to read than a row of zeros. Whole numbers below the
// upper end are exact, so their digits are all significant.
constexpr double smallestWithoutExponent = 1e-5;
constexpr double largestWithoutExponent = 1e15;

template <class Number> std::optional<Number> wholly(std::string_view text) {
    Number value{};
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    return error == std::errc() && stop == end ? std::optional(value) : std::nullopt;
}

} // namespace

std::string shortest(double value) {
    std::string text;
    appendShortest(text, value);
    return text;
}

void appendShortest(std::string& text, double value) {
    if (value == 0) {
        text += std::signbit(value) ? "-0.0" : "0";
        return;
    }
    std::array<char, 32> digits{};
    const double size = std::abs(value);
    const bool plain = size >= smallestWithoutExponent && size < largestWithoutExponent;
    char* const begin = digits.data();
    char* const end = begin + digits.size();
    const auto result = plain ? std::to_chars(begin, end, value, std::chars_format::fixed)
                              : std::to_chars(begin, end, value);
    text.append(begin, result.ptr);
}

std::optional<double> numberFrom(std::string_view text) {
    const auto value = wholly<double>(text);
    return value && std::isfinite(*value) ? value : std::nullopt;
}

std::optional<long long> wholeNumberFrom(std::string_view text) {
    return wholly<long long>(text);
}

} // namespace splineloft
