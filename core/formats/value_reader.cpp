#include "core/formats/value_reader.h"

#include <algorithm>

namespace splineloft {

std::string listed(const Keys& words) {
    std::string list;
    for (const auto word : words) {
        list += (list.empty() ? "" : ", ") + std::string(word);
    }
    return list;
}

void ValueReader::refuse(const JsonPlace& place, std::string what, std::string remedy) {
    if (!refusal_) {
        refusal_ = Refusal{"", place.pointer(), std::move(what), std::move(remedy)};
    }
}

void ValueReader::refuseProblem(const std::optional<Problem>& problem, const JsonPlace& within) {
    if (!problem || refusal_) {
        return;
    }
    refusal_ = Refusal{"", within.pointer() + problem->place, problem->what, problem->remedy};
}

bool ValueReader::expect(const JsonValue& value, JsonKind kind, const JsonPlace& place) {
    if (value.kind() == kind) {
        return true;
    }
    constexpr std::string_view verb = "is ";
    refuse(place, std::string(describe(value.kind())),
           std::string(describe(kind).substr(verb.size())));
    return false;
}

ValueReader::Members ValueReader::membersOf(const JsonValue& object, const JsonPlace& place) {
    Members members;
    if (expect(object, JsonKind::object, place)) {
        forEachMember(object, [&](std::string_view key, const JsonValue& value) {
            members.emplace(key, value);
        });
    }
    return members;
}

const JsonValue* ValueReader::optional(const Members& members, std::string_view key) {
    const auto found = members.find(key);
    return found == members.end() ? nullptr : &found->second;
}

const JsonValue* ValueReader::required(const Members& members, std::string_view key,
                                       const JsonPlace& place, std::string remedy) {
    const auto* value = optional(members, key);
    if (value == nullptr) {
        refuse({place, key}, "is missing", std::move(remedy));
    }
    return value;
}

void ValueReader::allowOnly(const Keys& keys, const Members& members, const JsonPlace& place,
                            std::string_view owner) {
    for (const auto& [key, value] : members) {
        if (std::ranges::find(keys, key) == keys.end()) {
            refuse({place, key}, inQuotes(key) + " is no key of " + std::string(owner),
                   "one of " + listed(keys) + "; other data may stand in the document's extras");
        }
    }
}

double ValueReader::number(const JsonValue& value, const JsonPlace& place) {
    return expect(value, JsonKind::number, place) ? value.number() : 0;
}

bool ValueReader::boolean(const JsonValue& value, const JsonPlace& place) {
    return expect(value, JsonKind::boolean, place) && value.boolean();
}

std::string ValueReader::text(const JsonValue& value, const JsonPlace& place) {
    if (!expect(value, JsonKind::text, place)) {
        return "";
    }
    if (value.text().find('\0') != std::string_view::npos) {
        refuse(place, "contains a NUL character", "text without it");
    }
    return std::string(value.text());
}

} // namespace splineloft
