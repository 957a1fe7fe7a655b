#include "core/formats/result.h"

#include <algorithm>

namespace splineloft {
namespace {

/// Longest text quoted in full, in bytes: about half a line of a terminal.
constexpr std::size_t longestQuotation = 48;

constexpr bool isControl(char c) {
    return static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
}

/// Control characters as \u00XX, so that a message stays on its line and leaves the terminal alone.
std::string onOneLine(std::string_view text) {
    constexpr std::string_view digits = "0123456789abcdef";
    std::string line;
    for (const char c : text) {
        if (isControl(c)) {
            const auto code = static_cast<unsigned char>(c);
            line += "\\u00";
            line += digits[code >> 4];
            line += digits[code & 15];
        } else {
            line += c;
        }
    }
    return line;
}

constexpr bool continuesCharacter(char c) {
    return (static_cast<unsigned char>(c) & 0xc0) == 0x80;
}

} // namespace

std::string Refusal::message() const {
    std::string line;
    for (const auto& part : {file, place}) {
        line += part.empty() ? "" : part + ": ";
    }
    line += what;
    if (!remedy.empty()) {
        line += "; right would be: " + remedy;
    }
    return onOneLine(line);
}

std::string inQuotes(std::string_view text) {
    if (text.size() <= longestQuotation) {
        return '"' + onOneLine(text) + '"';
    }
    auto length = longestQuotation;
    while (length > 0 && continuesCharacter(text[length])) {
        --length;
    }
    return '"' + onOneLine(text.substr(0, length)) + "…\"";
}

} // namespace splineloft
