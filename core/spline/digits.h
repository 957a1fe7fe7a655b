// Numbers in messages: digits as no locale changes them.
#pragma once

#include <string>

namespace splineloft {

/// The fewest digits from which the same number is read again.
std::string allDigits(double value);

/// Rounded to two digits.
std::string twoDigits(double value);

/// Rounded to three digits, without an exponent up to a million.
std::string threeDigits(double value);

} // namespace splineloft
