// Numbers as text: always with a decimal point, whatever the locale, and always exact.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace splineloft {

/// The fewest digits that read back as exactly `value`, with an exponent only for the very large
/// and the very small. Whole numbers have no fraction; minus zero is "-0.0", since a JSON reader
/// may take "-0" for an integer and lose the sign. `value` must be finite.
std::string shortest(double value);

/// Appends `shortest(value)`.
void appendShortest(std::string& text, double value);

/// The number that the whole of `text` spells, in decimal; nothing for anything else, also for
/// "inf" and "nan".
std::optional<double> numberFrom(std::string_view text);

/// The same for whole numbers.
std::optional<long long> wholeNumberFrom(std::string_view text);

} // namespace splineloft
