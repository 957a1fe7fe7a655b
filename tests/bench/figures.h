// Numbers as the table prints them, alike in every locale.
#pragma once

#include <array>
#include <charconv>
#include <string>

namespace splineloft::bench {

/// Three digits at least, none of them after the point from 100 on.
inline std::string figure(double value) {
    std::array<char, 64> text{};
    const int decimals = value < 10 ? 2 : (value < 100 ? 1 : 0);
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value,
                                   std::chars_format::fixed, decimals);
    return end.ec == std::errc() ? std::string(text.data(), end.ptr) : "?";
}

/// One digit and a power of ten, as "2e-9"; 0 where it is nothing.
inline std::string power(double value) {
    if (value == 0) {
        return "0";
    }
    std::array<char, 32> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value,
                                   std::chars_format::scientific, 0);
    std::string power(text.data(), end.ptr);
    constexpr std::size_t exponent = 3; // its place in "2e-09"
    if (power.size() == exponent + 2 && power[exponent] == '0') {
        power.erase(exponent, 1);
    }
    return power;
}

/// As few digits as say it.
inline std::string shortest(double value) {
    std::array<char, 32> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value);
    return {text.data(), end.ptr};
}

} // namespace splineloft::bench
