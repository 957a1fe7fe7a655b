#include "core/formats/svg_scanner.h"

#include "core/formats/numbers.h"

namespace splineloft {
namespace {

bool isDigit(char c) {
    return c >= '0' && c <= '9';
}

} // namespace

bool SvgScanner::atNumber() const {
    const char c = next();
    return isDigit(c) || c == '.' || c == '+' || c == '-';
}

char SvgScanner::letter() {
    const char c = data_[at_++];
    skipSpace();
    return c;
}

std::optional<double> SvgScanner::number() {
    const auto length = numberLength();
    auto token = data_.substr(at_, length);
    if (!token.empty() && token.front() == '+') {
        token.remove_prefix(1);
    }
    const auto value = numberFrom(token);
    if (value) {
        at_ += length;
        skipSeparator();
    }
    return value;
}

std::optional<bool> SvgScanner::flag() {
    if (next() != '0' && next() != '1') {
        return std::nullopt;
    }
    const bool value = data_[at_++] == '1';
    skipSeparator();
    return value;
}

void SvgScanner::skipSpace() {
    constexpr std::string_view space = " \t\r\n\f";
    while (!atEnd() && space.find(data_[at_]) != space.npos) {
        ++at_;
    }
}

void SvgScanner::skipSeparator() {
    skipSpace();
    if (next() == ',') {
        ++at_;
        skipSpace();
    }
}

/// A number ends where it can no longer go on: "1.5.5" are two, and so are "1-2".
std::size_t SvgScanner::numberLength() const {
    auto end = at_;
    const auto here = [&](std::size_t i) { return i < data_.size() ? data_[i] : '\0'; };
    const auto passDigits = [&] {
        while (isDigit(here(end))) {
            ++end;
        }
    };
    if (here(end) == '+' || here(end) == '-') {
        ++end;
    }
    passDigits();
    if (here(end) == '.') {
        ++end;
        passDigits();
    }
    if (here(end) == 'e' || here(end) == 'E') {
        const auto sign = here(end + 1) == '+' || here(end + 1) == '-' ? 1U : 0U;
        if (isDigit(here(end + 1 + sign))) {
            end += 1 + sign;
            passDigits();
        }
    }
    return end - at_;
}

} // namespace splineloft
