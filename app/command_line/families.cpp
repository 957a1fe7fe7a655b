// The catalog of families on the command line.
#include "app/command_line/commands.h"

#include "core/formats/json_text.h"
#include "core/formats/numbers.h"
#include "core/spline/catalog.h"

#include <algorithm>
#include <array>

namespace splineloft {
namespace {

std::string_view nameOf(Scale scale) {
    switch (scale) {
    case Scale::linear: return "linear";
    case Scale::ratio: return "ratio";
    case Scale::whole: return "whole";
    }
    return "";
}

std::size_t characters(std::string_view text) {
    return static_cast<std::size_t>(std::ranges::count_if(
        text, [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; }));
}

std::string parametersInWords(const Family& family) {
    std::string words;
    for (const auto& parameter : family.parameters) {
        words += (words.empty() ? "" : ", ") + std::string(parameter.key) + " " +
                 shortest(parameter.neutral);
    }
    return words.empty() ? "-" : words;
}

using Row = std::array<std::string, 4>;

void writeParameter(JsonText& json, const Parameter& parameter) {
    json.beginObject();
    const auto entry = [&](std::string_view key, std::string_view value) {
        json.key(key);
        json.text(value);
    };
    entry("key", parameter.key);
    entry("label", parameter.label);
    entry("symbol", parameter.symbol);
    json.key("range");
    json.numbers(std::array{parameter.least, parameter.most});
    json.key("slider");
    json.numbers(std::array{parameter.sliderLeast, parameter.sliderMost});
    json.key("neutral");
    json.number(parameter.neutral);
    entry("scale", nameOf(parameter.scale));
    json.key("local");
    json.boolean(parameter.local);
    entry("meaning", parameter.meaning);
    json.end();
}

void writeFamily(JsonText& json, const Family& family) {
    json.beginObject();
    const auto entry = [&](std::string_view key, std::string_view value) {
        json.key(key);
        json.text(value);
    };
    entry("id", family.id);
    entry("name", family.name);
    entry("summary", family.summary);
    entry("source", family.source);
    json.key("parameters");
    json.beginArray();
    for (const auto& parameter : family.parameters) {
        writeParameter(json, parameter);
    }
    json.end();
    json.key("ends");
    json.beginArray(Flow::inLine);
    for (const auto ends : family.ends) {
        json.text(nameOf(ends));
    }
    json.end();
    json.key("closable");
    json.boolean(family.closable);
    json.key("tangents");
    json.boolean(family.usesTangents);
    json.key("knots");
    json.boolean(family.usesKnots);
    json.key("weights");
    json.boolean(family.usesWeights);
    json.key("handles");
    json.boolean(family.hasHandles);
    json.key("mostPoints");
    json.count(family.mostPoints);
    json.end();
}

} // namespace

std::string familiesAsTable() {
    std::vector<Row> rows = {{"ID", "NAME", "PARAMETERS", "WHAT IT DOES"}};
    for (const auto& family : catalog()) {
        rows.push_back({std::string(family.id), std::string(family.name), parametersInWords(family),
                        std::string(family.summary)});
    }
    std::array<std::size_t, 4> widths{};
    for (const auto& row : rows) {
        for (std::size_t i = 0; i + 1 < row.size(); ++i) {
            widths[i] = std::max(widths[i], characters(row[i]));
        }
    }
    std::string table;
    for (const auto& row : rows) {
        for (std::size_t i = 0; i + 1 < row.size(); ++i) {
            table += row[i] + std::string(widths[i] + 2 - characters(row[i]), ' ');
        }
        table += row.back() + '\n';
    }
    return table;
}

std::string familiesAsJson() {
    JsonText json;
    json.beginArray();
    for (const auto& family : catalog()) {
        writeFamily(json, family);
    }
    json.end();
    return std::move(json).finished();
}

} // namespace splineloft
