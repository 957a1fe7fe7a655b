// Reading a document: what the format asks of the JSON values. What makes sense for a curve is
// known to the curves themselves (`problemOf`) and asked of them last.
#include "core/formats/document_json.h"
#include "core/formats/handling_json.h"
#include "core/formats/value_reader.h"
#include "core/spline/catalog.h"

#include <algorithm>

namespace splineloft {
namespace {

constexpr std::string_view extrasKey = "extras";

/// The keys that a curve of the family may have.
Keys curveKeys(const Family& family) {
    Keys keys = {"name", "family", "parameters", "coordinates", "points", "closed", "ends"};
    if (family.usesTangents) {
        keys.push_back("tangents");
    }
    if (family.usesKnots) {
        keys.push_back("knots");
    }
    if (family.usesWeights) {
        keys.push_back("weights");
    }
    if (std::ranges::any_of(family.parameters, &Parameter::local)) {
        keys.push_back("local");
    }
    return keys;
}

class DocumentReader : private ValueReader {
  public:
    Document document(const JsonValue& root) {
        const JsonPlace top;
        const auto members = membersOf(root, top);
        checkHead(members, top);
        allowOnly({"$schema", "format", "version", "curves", extrasKey}, members, top,
                  "a document");
        Document document;
        if (const auto* curves = required(members, "curves", top, "an array of curves")) {
            eachOf(*curves, {top, "curves"}, [&](const JsonValue& value, const JsonPlace& place) {
                document.curves.push_back(
                    std::make_shared<const Curve>(curve(value, place, document.curves.size())));
            });
        }
        if (const auto* extras = optional(members, extrasKey)) {
            readOwnExtras(*extras, {top, extrasKey}, document);
        }
        if (!refusal()) {
            refuseProblem(problemOf(document));
        }
        return document;
    }

    using ValueReader::refusal;

  private:
    void checkHead(const Members& members, const JsonPlace& top) {
        if (const auto* format = required(members, "format", top, "\"splineloft\"")) {
            if (const auto name = text(*format, {top, "format"}); name != "splineloft") {
                refuse({top, "format"}, "is " + inQuotes(name), "\"splineloft\"");
            }
        }
        if (const auto* version = required(members, "version", top, "1")) {
            if (number(*version, {top, "version"}) != 1) {
                refuse({top, "version"}, "is a version that this program does not know", "1");
            }
        }
        if (const auto* schema = optional(members, "$schema")) {
            text(*schema, {top, "$schema"});
        }
    }

    Curve curve(const JsonValue& value, const JsonPlace& place, std::size_t index) {
        const auto members = membersOf(value, place);
        Curve curve;
        const auto* id = required(members, "family", place, "the id of a spline family");
        if (id == nullptr) {
            return curve;
        }
        curve.family = text(*id, {place, "family"});
        const Family* family = findFamily(curve.family);
        if (family == nullptr) {
            refuseProblem(problemOf(curve), place);
            return curve;
        }
        allowKeys(*family, members, place);
        curve.name = "curve " + std::to_string(index + 1);
        if (const auto* name = optional(members, "name")) {
            curve.name = text(*name, {place, "name"});
        }
        readParameters(curve, *family, members, place);
        readTables(curve, *family, members, place);
        readLists(curve, members, place);
        readEnds(curve, *family, members, place);
        return curve;
    }

    void allowKeys(const Family& family, const Members& members, const JsonPlace& place) {
        const auto keys = curveKeys(family);
        for (const auto key : {"tangents", "knots", "weights", "local"}) {
            if (members.contains(key) && std::ranges::find(keys, key) == keys.end()) {
                refuse({place, key},
                       "the family " + std::string(family.id) + " takes no " + std::string(key),
                       "leave them out");
            }
        }
        allowOnly(keys, members, place, "a curve");
    }

    void readParameters(Curve& curve, const Family& family, const Members& members,
                        const JsonPlace& place) {
        for (const auto& parameter : family.parameters) {
            curve.parameters[std::string(parameter.key)] = parameter.neutral;
        }
        if (const auto* given = optional(members, "parameters")) {
            const JsonPlace here(place, "parameters");
            for (const auto& [key, value] : membersOf(*given, here)) {
                curve.parameters[std::string(key)] = number(value, {here, key});
            }
        }
    }

    void readTables(Curve& curve, const Family& family, const Members& members,
                    const JsonPlace& place) {
        const auto* names = optional(members, "coordinates");
        if (names != nullptr) {
            curve.coordinates = coordinateNames(*names, {place, "coordinates"});
        }
        const auto* points = required(members, "points", place, "an array of points");
        if (points == nullptr || refusal()) {
            return;
        }
        const auto named = static_cast<int>(curve.coordinates.size());
        curve.points = table(*points, {place, "points"}, named);
        if (names == nullptr) {
            curve.coordinates = usualCoordinates(curve.points.dimension());
        }
        if (family.usesTangents) {
            const auto* tangents =
                required(members, "tangents", place, "an array of tangents, one for each point");
            if (tangents != nullptr) {
                curve.tangents = table(*tangents, {place, "tangents"}, curve.points.dimension());
            }
        }
    }

    /// Knots, weights and local parameters.
    void readLists(Curve& curve, const Members& members, const JsonPlace& place) {
        if (const auto* knots = optional(members, "knots")) {
            curve.knots = numbers(*knots, {place, "knots"});
        }
        if (const auto* weights = optional(members, "weights")) {
            curve.weights = numbers(*weights, {place, "weights"});
        }
        if (const auto* local = optional(members, "local")) {
            const JsonPlace here(place, "local");
            for (const auto& [key, values] : membersOf(*local, here)) {
                curve.local[std::string(key)] = numbers(values, {here, key});
            }
        }
    }

    /// A list of numbers, at least one.
    std::vector<double> numbers(const JsonValue& value, const JsonPlace& place) {
        std::vector<double> list;
        eachOf(value, place, [&](const JsonValue& entry, const JsonPlace& here) {
            list.push_back(number(entry, here));
        });
        if (list.empty()) {
            refuse(place, "is empty", "numbers, or nothing at all");
        }
        return list;
    }

    std::vector<std::string> coordinateNames(const JsonValue& value, const JsonPlace& place) {
        std::vector<std::string> names;
        eachOf(value, place, [&](const JsonValue& name, const JsonPlace& here) {
            names.push_back(text(name, here));
        });
        if (names.empty() || names.size() > static_cast<std::size_t>(maxDimension)) {
            refuse(place, "has " + std::to_string(names.size()) + " names", "1 to 16 names");
        }
        return names;
    }

    /// Rows of numbers, as many in each as in the first; `usual` so many where there is no row.
    Points table(const JsonValue& value, const JsonPlace& place, int usual) {
        Points table(usual);
        eachOf(value, place, [&](const JsonValue& row, const JsonPlace& here) {
            Point point = this->row(row, here);
            if (refusal()) {
                return;
            }
            if (table.empty()) {
                table = Points(point.dimension());
            }
            if (point.dimension() != table.dimension()) {
                refuse(here, "has " + std::to_string(point.dimension()) + " coordinates",
                       std::to_string(table.dimension()) + ", as many as the first");
                return;
            }
            table.append(point);
        });
        return table;
    }

    Point row(const JsonValue& value, const JsonPlace& place) {
        std::array<double, maxDimension> numbers{};
        std::size_t count = 0;
        eachOf(value, place, [&](const JsonValue& entry, const JsonPlace& here) {
            if (count < numbers.size()) {
                numbers[count] = number(entry, here);
            }
            ++count;
        });
        if (count == 0 || count > numbers.size()) {
            refuse(place, "has " + std::to_string(count) + " coordinates", "1 to 16 coordinates");
            return Point(1);
        }
        return Point(std::span(numbers).first(count));
    }

    void readEnds(Curve& curve, const Family& family, const Members& members,
                  const JsonPlace& place) {
        const auto* closed = optional(members, "closed");
        curve.closed = closed != nullptr && expect(*closed, JsonKind::boolean, {place, "closed"}) &&
                       closed->boolean();
        curve.ends = curve.knots.empty() ? family.ends.front() : Ends::none;
        const auto* given = optional(members, "ends");
        if (given == nullptr) {
            return;
        }
        const auto word = text(*given, {place, "ends"});
        Keys words;
        for (const auto ends :
             {Ends::none, Ends::open, Ends::doubled, Ends::reflected, Ends::clamped}) {
            words.push_back(nameOf(ends));
            curve.ends = nameOf(ends) == word ? ends : curve.ends;
        }
        if (std::ranges::find(words, word) == words.end()) {
            refuse({place, "ends"}, "is " + inQuotes(word), "one of " + listed(words));
        }
    }

    /// What this program keeps in the extras; on the tape there is nothing else in them.
    void readOwnExtras(const JsonValue& extras, const JsonPlace& place, Document& document) {
        const auto members = membersOf(extras, place);
        if (const auto* own = optional(members, ownExtrasKey)) {
            readHandling(*own, {place, ownExtrasKey}, *this, document);
        }
    }
};

} // namespace

Result<Document> readDocument(std::string_view text) {
    const auto tape = readJson(text, {extrasKey, ownExtrasKey});
    if (!tape) {
        return tape.refusal();
    }
    DocumentReader reader;
    Document document = reader.document(tape->root());
    if (reader.refusal()) {
        return *reader.refusal();
    }
    if (!tape->keptText().empty()) {
        document.extras = tape->keptText();
    }
    return document;
}

} // namespace splineloft
