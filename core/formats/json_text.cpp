#include "core/formats/json_text.h"

#include "core/formats/numbers.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <stdexcept>

namespace splineloft {
namespace {

std::string spelled(std::string_view value) {
    constexpr int noIndent = -1;
    constexpr bool asciiOnly = false;
    return nlohmann::json(value).dump(noIndent, ' ', asciiOnly,
                                      nlohmann::json::error_handler_t::replace);
}

} // namespace

std::string asSaved(std::string_view text) {
    return nlohmann::json::parse(spelled(text)).get<std::string>();
}

/// The comma and the space or line break that separate a value, or a key, from what precedes it.
void JsonText::beforeValue(bool isContainer) {
    if (afterKey_) {
        afterKey_ = false;
        return;
    }
    if (levels_.empty()) {
        return;
    }
    auto& level = levels_.back();
    if (level.flow == Flow::asFirst) {
        level.flow = isContainer ? Flow::stacked : Flow::inLine;
    }
    if (!level.empty) {
        text_ += level.flow == Flow::inLine ? ", " : ",";
    }
    level.empty = false;
    if (level.flow == Flow::stacked) {
        breakLine();
    }
}

void JsonText::begin(char closing, Flow flow) {
    constexpr bool isContainer = true;
    beforeValue(isContainer);
    const bool insideLine = !levels_.empty() && levels_.back().flow == Flow::inLine;
    text_ += closing == '}' ? '{' : '[';
    levels_.push_back({closing, insideLine ? Flow::inLine : flow});
}

void JsonText::end() {
    const auto level = levels_.back();
    levels_.pop_back();
    if (!level.empty && level.flow == Flow::stacked) {
        breakLine();
    }
    text_ += level.closing;
}

void JsonText::key(std::string_view name) {
    constexpr bool isContainer = false;
    beforeValue(isContainer);
    text_ += spelled(name);
    text_ += ": ";
    afterKey_ = true;
}

void JsonText::text(std::string_view value) {
    raw(spelled(value));
}

void JsonText::number(double value) {
    if (!std::isfinite(value)) {
        throw std::invalid_argument("a number to be written as JSON must be finite");
    }
    constexpr bool isContainer = false;
    beforeValue(isContainer);
    appendShortest(text_, value);
}

void JsonText::raw(std::string_view value) {
    constexpr bool isContainer = false;
    beforeValue(isContainer);
    for (const char c : value) {
        if (c == '\n') {
            breakLine();
        } else {
            text_ += c;
        }
    }
}

void JsonText::numbers(std::span<const double> values) {
    beginArray(Flow::inLine);
    for (const double value : values) {
        number(value);
    }
    end();
}

void JsonText::texts(std::span<const std::string> values) {
    beginArray(Flow::inLine);
    for (const auto& value : values) {
        text(value);
    }
    end();
}

void JsonText::numberOrNull(const std::optional<double>& value) {
    if (value && std::isfinite(*value)) {
        number(*value);
    } else {
        null();
    }
}

} // namespace splineloft
