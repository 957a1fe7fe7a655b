#include "core/formats/json_tape.h"

#include "core/spline/problem.h"

namespace splineloft {
std::string_view describe(JsonKind kind) {
    switch (kind) {
    case JsonKind::null: return "is null";
    case JsonKind::boolean: return "is true or false";
    case JsonKind::number: return "is a number";
    case JsonKind::text: return "is a string";
    case JsonKind::array: return "is an array";
    case JsonKind::object: return "is an object";
    }
    return "";
}

std::string JsonPlace::pointer() const {
    if (within_ == nullptr) {
        return "";
    }
    return within_->pointer() + (index_ == notAnIndex ? pointerToken(key_) : pointerToken(index_));
}

const JsonCell& JsonValue::cell() const {
    return tape_->cells_[at_];
}

std::string_view JsonValue::text() const {
    const auto& where = cell().text;
    return std::string_view(tape_->letters_).substr(where.start, where.length);
}

std::optional<JsonValue> memberOf(const JsonValue& object, std::string_view key) {
    std::optional<JsonValue> found;
    if (object.kind() == JsonKind::object) {
        forEachMember(object, [&](std::string_view name, const JsonValue& value) {
            if (name == key) {
                found = value;
            }
        });
    }
    return found;
}

} // namespace splineloft
