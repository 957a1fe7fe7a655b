#include "ui/canvas/wording.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace splineloft::ui {
namespace {

template <class... Form> std::string written(double value, Form... form) {
    std::array<char, 400> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value, form...).ptr;
    return {text.data(), end};
}

} // namespace

std::string withTrueMinus(std::string text) {
    const bool zero = text.find_first_of("123456789") == std::string::npos;
    if (!text.empty() && text.front() == '-') {
        text.replace(0, 1, zero ? "" : "−");
    }
    return text;
}

std::string fixed(double value, int digits) {
    return withTrueMinus(written(value, std::chars_format::fixed, digits));
}

std::string decimal(double value, double step) {
    const int digits = static_cast<int>(std::ceil(-std::log10(step) - 1e-9));
    if (digits <= 6 && step < 1e7) {
        return fixed(value, std::max(digits, 0));
    }
    // As many as tell the multiple from the next one; beyond 16 a double has none to tell.
    const double places = std::log10(std::max(std::abs(value), step)) + digits;
    return significant(value, std::clamp(static_cast<int>(std::floor(places + 1e-9)) + 1, 6, 16));
}

std::string significant(double value, int digits) {
    return withTrueMinus(written(value, std::chars_format::general, digits));
}

std::string shortened(double value, int digits) {
    return written(value, std::chars_format::general, digits);
}

std::string exact(double value) {
    return written(value);
}

std::string pointName(std::size_t index) {
    return "P_" + std::to_string(index);
}

std::string plainPointName(std::size_t index) {
    static constexpr std::array<const char*, 10> lowered = {"₀", "₁", "₂", "₃", "₄",
                                                            "₅", "₆", "₇", "₈", "₉"};
    std::string name = "P";
    for (const char digit : std::to_string(index)) {
        name += lowered[static_cast<std::size_t>(digit - '0')];
    }
    return name;
}

} // namespace splineloft::ui
