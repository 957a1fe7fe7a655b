#include "app/command_line/commands.h"

#include "core/formats/document_json.h"
#include "core/formats/file.h"
#include "core/formats/json_text.h"
#include "core/formats/numbers.h"
#include "core/spline/catalog.h"
#include "core/spline/change/convert.h"
#include "core/spline/continuity.h"
#include "core/spline/measure/bounds.h"
#include "core/spline/measure/length.h"
#include "core/spline/shape/self_intersect.h"
#include "core/spline/shape/turning.h"

#include <algorithm>
#include <istream>
#include <numeric>
#include <optional>

namespace splineloft {
namespace {

/// Most curves named in the answer to a curve that does not exist.
constexpr std::size_t mostNamed = 12;

/// A curve of a document that was read from a file.
struct Chosen {
    std::shared_ptr<const Curve> curve;
    std::string file, place; ///< for refusals

    Refusal refuse(Refusal refusal) const {
        return {file, place + refusal.place, refusal.what, refusal.remedy};
    }
};

std::string nameOfFile(const std::string& file) {
    return file == "-" ? "standard input" : file;
}

std::string range(double least, double most) {
    return shortest(least) + " to " + shortest(most);
}

std::string counted(std::size_t count, const std::string& noun) {
    return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

std::string curvesOf(const Document& document) {
    std::string list;
    for (std::size_t i = 0; i < std::min(document.curves.size(), mostNamed); ++i) {
        list += (i == 0 ? "" : ", ") + std::to_string(i) + " " + inQuotes(document.curves[i]->name);
    }
    return document.curves.size() > mostNamed ? list + ", ..." : list;
}

/// The index of the curve that bears the name, else of the one whose index it is.
Result<std::size_t> indexOf(const Document& document, const std::string& wanted) {
    const auto& curves = document.curves;
    const auto bearsName = [&](const auto& curve) { return curve->name == wanted; };
    const auto found = std::ranges::find_if(curves, bearsName);
    if (found == curves.end()) {
        const auto index = wholeNumberFrom(wanted);
        if (index && *index >= 0 && static_cast<std::size_t>(*index) < curves.size()) {
            return static_cast<std::size_t>(*index);
        }
        return Refusal{"", "/curves", "there is no curve " + inQuotes(wanted),
                       "one of " + curvesOf(document)};
    }
    if (std::ranges::count_if(curves, bearsName) > 1) {
        return Refusal{"", "/curves", "several curves bear the name " + inQuotes(wanted),
                       "an index: " + curvesOf(document)};
    }
    return static_cast<std::size_t>(found - curves.begin());
}

Result<Chosen> choose(const CurveChoice& choice, std::istream& standardInput) {
    const auto document = openDocument(choice.file, standardInput);
    if (!document) {
        return document.refusal();
    }
    const auto file = nameOfFile(choice.file);
    if (document->curves.empty()) {
        return Refusal{file, "/curves", "there is no curve in it", "a document with a curve"};
    }
    const auto index = choice.curve ? indexOf(*document, *choice.curve) : std::size_t{0};
    if (!index) {
        auto refusal = index.refusal();
        refusal.file = file;
        return refusal;
    }
    return Chosen{document->curves[*index].curve, file, "/curves/" + std::to_string(*index)};
}

/// The spots that are asked for, if the curve has them.
Result<std::vector<Spot>> spotsOf(const SpotQuery& query, const KnotLine& knots) {
    std::vector<Spot> spots;
    if (!query.segment) {
        for (const double t : query.values) {
            if (t < knots.start() || t > knots.end()) {
                return Refusal{"", "", "there is no t = " + shortest(t),
                               range(knots.start(), knots.end())};
            }
            spots.push_back(knots.locate(t));
        }
        return spots;
    }
    if (*query.segment < 0 || static_cast<std::size_t>(*query.segment) >= knots.pieces()) {
        return Refusal{"", "", "there is no segment " + std::to_string(*query.segment),
                       "0 to " + std::to_string(knots.pieces() - 1)};
    }
    for (const double u : query.values) {
        if (u < 0 || u > 1) {
            return Refusal{"", "", "there is no u = " + shortest(u), range(0, 1)};
        }
        spots.push_back({static_cast<std::size_t>(*query.segment), u});
    }
    return spots;
}

void writeSpot(JsonText& json, const Spot& spot, const Pieces& pieces) {
    json.key("segment");
    json.count(spot.segment);
    json.key("u");
    json.number(spot.u);
    json.key("t");
    json.number(pieces.knots().parameter(spot));
}

void writeJet(JsonText& json, const Spot& spot, const Pieces& pieces, const Jet& jet) {
    json.beginObject(Flow::inLine);
    writeSpot(json, spot, pieces);
    json.key("position");
    json.numbers(jet.position.coordinates());
    json.key("first");
    json.numbers(jet.first.coordinates());
    json.key("second");
    json.numbers(jet.second.coordinates());
    json.key("curvature");
    json.numberOrNull(jet.curvature);
    json.end();
}

void writeJoint(JsonText& json, const Joint& joint) {
    json.beginObject(Flow::inLine);
    json.key("t");
    json.number(joint.t);
    json.key("c");
    json.raw(std::to_string(joint.c));
    json.key("g");
    json.raw(std::to_string(joint.g));
    json.key("residuals");
    json.beginObject(Flow::inLine);
    const auto residual = [&](const char* name, double value) {
        json.key(name);
        json.numberOrNull(value);
    };
    residual("position", joint.gap);
    residual("first", joint.firstJump);
    residual("second", joint.secondJump);
    residual("direction", joint.turn);
    residual("curvature", joint.curvatureJump);
    residual("speedRatio", joint.speedRatio);
    json.end();
    json.end();
}

void writeSpots(JsonText& json, std::string_view key, const std::vector<Spot>& spots,
                const Pieces& pieces) {
    json.key(key);
    json.beginArray();
    for (const auto& spot : spots) {
        json.beginObject(Flow::inLine);
        writeSpot(json, spot, pieces);
        json.key("position");
        json.numbers(pieces.position(spot).coordinates());
        json.end();
    }
    json.end();
}

void writeCrossings(JsonText& json, const SelfCrossings& found, const Pieces& pieces) {
    json.key("selfIntersections");
    json.beginArray();
    for (const auto& crossing : found.crossings) {
        json.beginObject(Flow::inLine);
        const auto writeEnd = [&](std::string_view key, const Spot& spot) {
            json.key(key);
            json.beginObject(Flow::inLine);
            writeSpot(json, spot, pieces);
            json.end();
        };
        writeEnd("a", crossing.a);
        writeEnd("b", crossing.b);
        json.key("position");
        json.numbers(crossing.place.coordinates());
        json.end();
    }
    json.end();
    json.key("selfIntersectionsComplete");
    json.boolean(found.complete);
}

/// Derivatives by t are too large for numbers where a piece takes next to no t. By u they are not.
std::optional<Refusal> problemOfJet(const Jet& jet, const Spot& spot, const Pieces& pieces) {
    if (isFinite(jet.first) && isFinite(jet.second)) {
        return std::nullopt;
    }
    return Refusal{"", "",
                   "the derivatives by t at t = " + shortest(pieces.knots().parameter(spot)) +
                       " are too large for numbers",
                   "--segment " + std::to_string(spot.segment) + " --u " + shortest(spot.u) +
                       ", for derivatives by u; or a wider range of t"};
}

void writeWeights(JsonText& json, std::string_view key, const Blend& blend, std::size_t first,
                  std::size_t count) {
    std::vector<double> weights(count);
    for (const auto& share : blend.shares()) {
        if (share.control >= first && share.control < first + count) {
            weights[share.control - first] = share.weight;
        }
    }
    json.key(key);
    json.numbers(weights);
}

} // namespace

Result<Document> openDocument(const std::string& file, std::istream& standardInput) {
    const auto name = nameOfFile(file);
    const auto text = file == "-" ? readStream(standardInput, name) : readFile(file);
    if (!text) {
        return text.refusal();
    }
    auto document = readDocument(*text);
    if (!document) {
        auto refusal = document.refusal();
        refusal.file = name;
        return refusal;
    }
    return document;
}

Result<std::string> evaluate(const SpotQuery& query, std::istream& standardInput) {
    const auto chosen = choose(query.choice, standardInput);
    if (!chosen) {
        return chosen.refusal();
    }
    const auto pieces = piecesOf(*chosen->curve);
    if (pieces.empty()) {
        return chosen->refuse(tooFewPoints(*chosen->curve));
    }
    const auto spots = spotsOf(query, pieces.knots());
    if (!spots) {
        return chosen->refuse(spots.refusal());
    }
    JsonText json;
    json.beginArray();
    for (const auto& spot : *spots) {
        const Jet jet = query.segment ? pieces.jet(spot) : pieces.jetByParameter(spot);
        if (auto problem = problemOfJet(jet, spot, pieces)) {
            return chosen->refuse(*std::move(problem));
        }
        writeJet(json, spot, pieces, jet);
    }
    json.end();
    return std::move(json).finished();
}

Result<std::string> basisAt(const SpotQuery& query, std::istream& standardInput) {
    const auto chosen = choose(query.choice, standardInput);
    if (!chosen) {
        return chosen.refusal();
    }
    const auto& curve = *chosen->curve;
    const auto pieces = piecesOf(curve);
    if (pieces.empty()) {
        return chosen->refuse(tooFewPoints(curve));
    }
    const auto spots = spotsOf(query, pieces.knots());
    if (!spots) {
        return chosen->refuse(spots.refusal());
    }
    const auto count = curve.points.size();
    JsonText json;
    json.beginArray();
    for (const auto& spot : *spots) {
        const auto basis = blendsOfPiece(curve, spot.segment).basis({0, spot.u});
        json.beginObject(Flow::inLine);
        json.key("t");
        json.number(pieces.knots().parameter(spot));
        writeWeights(json, "weights", basis, 0, count);
        if (familyOf(curve).usesTangents) {
            writeWeights(json, "tangentWeights", basis, count, count);
        }
        json.end();
    }
    json.end();
    return std::move(json).finished();
}

Result<std::string> measure(const CurveChoice& choice, std::istream& standardInput) {
    const auto chosen = choose(choice, standardInput);
    if (!chosen) {
        return chosen.refusal();
    }
    const auto pieces = piecesOf(*chosen->curve);
    const auto box = bounds(pieces);
    if (!box) {
        return chosen->refuse(tooFewPoints(*chosen->curve));
    }
    JsonText json;
    json.beginObject();
    json.key("length");
    json.number(ArcLength(pieces).total());
    json.key("bounds");
    json.beginObject(Flow::inLine);
    json.key("low");
    json.numbers(box->low.coordinates());
    json.key("high");
    json.numbers(box->high.coordinates());
    json.end();
    json.key("joints");
    json.beginArray();
    for (const auto& joint : jointsOf(pieces, chosen->curve->closed)) {
        writeJoint(json, joint);
    }
    json.end();
    writeSpots(json, "cusps", cusps(pieces), pieces);
    if (pieces.dimension() == 2) {
        writeSpots(json, "inflections", inflections(pieces), pieces);
        writeCrossings(json, selfIntersections(pieces), pieces);
    }
    json.end();
    return std::move(json).finished();
}

Result<std::string> convert(const std::string& file, const std::optional<std::string>& family,
                            std::istream& standardInput) {
    auto document = openDocument(file, standardInput);
    if (!document) {
        return document.refusal();
    }
    for (std::size_t i = 0; family && i < document->curves.size(); ++i) {
        auto result = converted(*document->curves[i], *family);
        if (const auto* problem = std::get_if<Problem>(&result)) {
            return Refusal{nameOfFile(file), "/curves/" + std::to_string(i) + problem->place,
                           problem->what, problem->remedy};
        }
        document->curves[i] = std::make_shared<Curve>(std::get<Curve>(std::move(result)));
    }
    return writeDocument(*document);
}

Result<SampledPath> sample(const CurveChoice& choice, const Sampling& sampling,
                           std::istream& standardInput) {
    const auto chosen = choose(choice, standardInput);
    if (!chosen) {
        return chosen.refusal();
    }
    auto path = sampledPath(*chosen->curve, sampling);
    if (!path) {
        return chosen->refuse(path.refusal());
    }
    return path;
}

Result<std::string> checkFile(const std::string& file, std::istream& standardInput) {
    const auto document = openDocument(file, standardInput);
    if (!document) {
        return document.refusal();
    }
    const auto& curves = document->curves;
    const auto points =
        std::accumulate(curves.begin(), curves.end(), std::size_t{0},
                        [](auto sum, const auto& curve) { return sum + curve->points.size(); });
    return nameOfFile(file) + ": ok (" + counted(curves.size(), "curve") + ", " +
           counted(points, "point") + ")\n";
}

} // namespace splineloft
