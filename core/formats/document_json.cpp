#include "core/formats/document_json.h"

#include "core/formats/handling_json.h"
#include "core/formats/json_text.h"
#include "core/spline/catalog.h"

#include <array>
#include <stdexcept>

namespace splineloft {
namespace {

void writeTable(JsonText& json, std::string_view key, const Points& table) {
    json.key(key);
    json.beginArray();
    for (std::size_t i = 0; i < table.size(); ++i) {
        json.numbers(table[i]);
    }
    json.end();
}

void writeParameters(JsonText& json, const Curve& curve) {
    const auto& parameters = familyOf(curve).parameters;
    const auto values = parametersOf(curve);
    json.key("parameters");
    json.beginObject(Flow::inLine);
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        json.key(parameters[i].key);
        json.number(values[i]);
    }
    json.end();
}

void writeNumbers(JsonText& json, std::string_view key, const std::vector<double>& numbers) {
    if (!numbers.empty()) {
        json.key(key);
        json.numbers(numbers);
    }
}

void writeCurve(JsonText& json, const Curve& curve) {
    json.beginObject();
    json.key("name");
    json.text(curve.name);
    json.key("family");
    json.text(curve.family);
    writeParameters(json, curve);
    json.key("coordinates");
    json.texts(curve.coordinates);
    writeTable(json, "points", curve.points);
    if (familyOf(curve).usesTangents) {
        writeTable(json, "tangents", curve.tangents);
    }
    writeNumbers(json, "knots", curve.knots);
    writeNumbers(json, "weights", curve.weights);
    if (!curve.local.empty()) {
        json.key("local");
        json.beginObject();
        for (const auto& [key, values] : curve.local) {
            json.key(key);
            json.numbers(values);
        }
        json.end();
    }
    json.key("closed");
    json.boolean(curve.closed);
    json.key("ends");
    json.text(nameOf(curve.ends));
    json.end();
}

/// The document's extras with what this program adds to them.
Result<std::string> extrasOf(const Document& document) {
    auto extras = tidyObject(document.extras);
    const auto own = handlingAsJson(document);
    if (!extras || own.empty()) {
        return extras;
    }
    const auto others = std::string_view(*extras).substr(0, extras->rfind('}'));
    const bool alone = *extras == "{}";
    return tidyObject(std::string(others) + (alone ? "\"" : ", \"") + std::string(ownExtrasKey) +
                      "\": " + own + "}");
}

} // namespace

std::string writeDocument(const Document& document) {
    if (const auto problem = problemOf(document)) {
        throw std::invalid_argument(problem->place + " " + problem->what);
    }
    const auto extras = extrasOf(document);
    if (!extras) {
        throw std::invalid_argument("extras: " + extras.refusal().message());
    }
    JsonText json;
    json.beginObject();
    json.key("$schema");
    json.text("urn:splineloft:document:1");
    json.key("format");
    json.text("splineloft");
    json.key("version");
    json.count(1);
    json.key("curves");
    json.beginArray();
    for (const auto& curve : document.curves) {
        writeCurve(json, *curve);
    }
    json.end();
    json.key("extras");
    json.raw(*extras);
    json.end();
    return std::move(json).finished();
}

std::vector<std::string> usualCoordinates(int dimension) {
    constexpr std::array first = {"x", "y", "z", "w"};
    std::vector<std::string> names;
    for (int i = 0; i < dimension; ++i) {
        const auto at = static_cast<std::size_t>(i);
        names.emplace_back(at < first.size() ? first[at] : "c");
        if (at >= first.size()) {
            names.back() += std::to_string(i);
        }
    }
    return names;
}

} // namespace splineloft
