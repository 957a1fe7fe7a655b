#include "core/formats/handling_json.h"

#include "core/document/handle_modes.h"
#include "core/document/handles.h"
#include "core/formats/json_text.h"
#include "core/formats/numbers.h"

#include <algorithm>
#include <array>

namespace splineloft {
namespace {

constexpr std::array modes = {HandleMode::corner, HandleMode::aligned, HandleMode::mirrored,
                              HandleMode::automatic};

bool isUsual(const CurveEntry& entry) {
    return entry.look == Look{} && entry.handleModes.empty();
}

void writeEntry(JsonText& json, const CurveEntry& entry) {
    const Look usual;
    json.beginObject();
    if (entry.look.visible != usual.visible) {
        json.key("visible");
        json.boolean(entry.look.visible);
    }
    if (entry.look.locked != usual.locked) {
        json.key("locked");
        json.boolean(entry.look.locked);
    }
    if (entry.look.colour != usual.colour) {
        json.key("colour");
        json.number(entry.look.colour);
    }
    if (!entry.handleModes.empty()) {
        json.key("handles");
        json.beginObject();
        for (const auto& [anchor, mode] : entry.handleModes) {
            json.key(std::to_string(anchor));
            json.text(nameOf(mode));
        }
        json.end();
    }
    json.end();
}

int colour(const JsonValue& value, const JsonPlace& place, ValueReader& reader) {
    const double number = reader.number(value, place);
    for (int colour = 0; colour <= curveColours; ++colour) {
        if (number == colour) {
            return colour;
        }
    }
    reader.refuse(place, "is " + shortest(number),
                  "a whole number from 0 to " + std::to_string(curveColours));
    return 0;
}

/// The anchor that a key names by its index.
std::optional<std::size_t> anchorNamed(std::string_view key, const Curve& curve) {
    const auto index = wholeNumberFrom(key);
    if (!index || *index < 0 || std::to_string(*index) != key || *index % 3 != 0) {
        return std::nullopt;
    }
    const auto anchor = static_cast<std::size_t>(*index);
    return hasHandles(curve) && anchor < curve.points.size() ? std::optional(anchor) : std::nullopt;
}

HandleMode mode(const JsonValue& value, const JsonPlace& place, ValueReader& reader) {
    const auto word = reader.text(value, place);
    Keys names;
    for (const auto mode : modes) {
        if (word == nameOf(mode)) {
            return mode;
        }
        names.push_back(nameOf(mode));
    }
    reader.refuse(place, "is " + inQuotes(word), "one of " + listed(names));
    return HandleMode::corner;
}

void readHandles(const JsonValue& value, const JsonPlace& place, ValueReader& reader,
                 CurveEntry& entry) {
    for (const auto& [key, name] : reader.membersOf(value, place)) {
        const JsonPlace here(place, key);
        const auto anchor = anchorNamed(key, *entry);
        if (!anchor) {
            reader.refuse(here, inQuotes(key) + " is no anchor of the curve",
                          "the index of an anchor of a Bézier spline: 0, 3, 6, ...");
            return;
        }
        entry.handleModes[*anchor] = mode(name, here, reader);
    }
}

void readEntry(const JsonValue& value, const JsonPlace& place, ValueReader& reader,
               CurveEntry& entry) {
    const auto members = reader.membersOf(value, place);
    reader.allowOnly({"visible", "locked", "colour", "handles"}, members, place,
                     "how a curve is handled");
    if (const auto* visible = ValueReader::optional(members, "visible")) {
        entry.look.visible = reader.boolean(*visible, {place, "visible"});
    }
    if (const auto* locked = ValueReader::optional(members, "locked")) {
        entry.look.locked = reader.boolean(*locked, {place, "locked"});
    }
    if (const auto* given = ValueReader::optional(members, "colour")) {
        entry.look.colour = colour(*given, {place, "colour"}, reader);
    }
    if (const auto* handles = ValueReader::optional(members, "handles")) {
        readHandles(*handles, {place, "handles"}, reader, entry);
    }
}

} // namespace

std::string handlingAsJson(const Document& document) {
    auto rest = document.curves.end();
    while (rest != document.curves.begin() && isUsual(*std::prev(rest))) {
        --rest;
    }
    if (rest == document.curves.begin()) {
        return "";
    }
    JsonText json;
    json.beginObject();
    json.key("curves");
    json.beginArray();
    for (auto entry = document.curves.begin(); entry != rest; ++entry) {
        writeEntry(json, *entry);
    }
    json.end();
    json.end();
    return json.str();
}

void readHandling(const JsonValue& value, const JsonPlace& place, ValueReader& reader,
                  Document& document) {
    const auto members = reader.membersOf(value, place);
    reader.allowOnly({"curves"}, members, place, "this program's extras");
    const auto* curves = ValueReader::optional(members, "curves");
    if (reader.refusal() || curves == nullptr) {
        return;
    }
    std::size_t index = 0;
    reader.eachOf(*curves, {place, "curves"}, [&](const JsonValue& entry, const JsonPlace& here) {
        if (index == document.curves.size()) {
            reader.refuse(here, "is more than there are curves",
                          "at most " + std::to_string(index) + " entries");
            return;
        }
        readEntry(entry, here, reader, document.curves[index++]);
    });
}

} // namespace splineloft
