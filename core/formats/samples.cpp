#include "core/formats/samples.h"

#include "core/formats/json_text.h"
#include "core/formats/numbers.h"

#include <algorithm>
#include <cmath>

namespace splineloft {
namespace {

std::string_view nameOf(EvenSamples::In in) {
    switch (in) {
    case EvenSamples::In::parameter: return "parameter";
    case EvenSamples::In::length: return "length";
    case EvenSamples::In::time: return "time";
    }
    return "";
}

double timeOf(const Sample& sample, const SampledPath& path) {
    return path.length > 0 ? sample.length / path.length : 0;
}

/// A field of a CSV file: quoted where it has to be.
std::string field(const std::string& text) {
    if (text.find_first_of(",\"\r\n") == text.npos) {
        return text;
    }
    std::string quotation = "\"";
    for (const char c : text) {
        quotation.append(c == '"' ? 2 : 1, c);
    }
    return quotation + '"';
}

std::vector<std::string> columnsOf(const SampledPath& path) {
    std::vector<std::string> columns = {"t", "length", "time"};
    const auto add = [&](std::string name) {
        while (std::ranges::find(columns, name) != columns.end()) {
            name += '_';
        }
        columns.push_back(std::move(name));
    };
    for (const auto& name : path.coordinates) {
        add(name);
    }
    for (const auto& name : path.coordinates) {
        add("tangent_" + name);
    }
    add("curvature");
    return columns;
}

struct Sampler {
    const Pieces& pieces;
    const ArcLength& lengths;

    std::vector<Spot> operator()(const StepsPerPiece& sampling) const {
        return spreadPerPiece(pieces, sampling.steps);
    }
    std::vector<Spot> operator()(const EvenSamples& sampling) const {
        const bool byParameter = sampling.in == EvenSamples::In::parameter;
        return spread(pieces, lengths, byParameter ? Even::parameter : Even::length,
                      sampling.count);
    }
};

std::optional<Refusal> countRefusal(const Sampling& sampling, std::size_t pieces) {
    const auto* perPiece = std::get_if<StepsPerPiece>(&sampling);
    const auto least = perPiece != nullptr ? std::size_t{1} : std::size_t{2};
    const auto most = perPiece != nullptr ? (mostSamples - 1) / pieces : mostSamples;
    const auto asked =
        perPiece != nullptr ? perPiece->steps : std::get<EvenSamples>(sampling).count;
    if (asked >= least && asked <= most) {
        return std::nullopt;
    }
    return Refusal{"", "",
                   std::to_string(asked) + (perPiece != nullptr ? " steps a piece" : " samples"),
                   std::to_string(least) + " to " + std::to_string(most)};
}

} // namespace

Refusal tooFewPoints(const Curve& curve) {
    const auto fewest = fewestPoints(curve);
    const auto missing = fewest - std::min(fewest, curve.points.size());
    return {"", "/points",
            "the curve has no piece yet: it needs " + std::to_string(missing) + " more point" +
                (missing == 1 ? "" : "s"),
            "at least " + std::to_string(fewest) + " points"};
}

Result<SampledPath> sampledPath(const Curve& curve, const Sampling& sampling) {
    const auto pieces = piecesOf(curve);
    if (pieces.empty()) {
        return tooFewPoints(curve);
    }
    if (auto refusal = countRefusal(sampling, pieces.size())) {
        return *refusal;
    }
    const ArcLength lengths(pieces);
    const auto* even = std::get_if<EvenSamples>(&sampling);
    return SampledPath{curve.name,
                       curve.family,
                       curve.coordinates,
                       std::string(even != nullptr ? nameOf(even->in) : "per-segment"),
                       lengths.total(),
                       samplesAt(pieces, lengths, std::visit(Sampler{pieces, lengths}, sampling))};
}

std::string samplesAsCsv(const SampledPath& path) {
    std::string csv;
    for (const auto& column : columnsOf(path)) {
        csv += csv.empty() ? "" : ",";
        csv += field(column);
    }
    csv += '\n';
    for (const auto& sample : path.samples) {
        appendShortest(csv, sample.t);
        for (const double value : {sample.length, timeOf(sample, path)}) {
            appendShortest(csv += ',', value);
        }
        for (const auto& point : {sample.position, sample.tangent}) {
            for (const double value : point.coordinates()) {
                appendShortest(csv += ',', value);
            }
        }
        csv += ',';
        if (sample.curvature && std::isfinite(*sample.curvature)) {
            appendShortest(csv, *sample.curvature);
        }
        csv += '\n';
    }
    return csv;
}

std::string samplesAsJson(const SampledPath& path) {
    JsonText json;
    json.beginObject();
    const auto entry = [&](std::string_view key, std::string_view value) {
        json.key(key);
        json.text(value);
    };
    entry("format", "splineloft-samples");
    json.key("version");
    json.count(1);
    entry("generator", "Splineloft");
    entry("units", "time: part of the way at constant speed, 0 to 1; tangent: derivative of the "
                   "position by t; curvature: 1 / unit of length; axes as in the curve, y up");
    entry("curve", path.curve);
    entry("family", path.family);
    json.key("coordinates");
    json.texts(path.coordinates);
    entry("spacing", path.spacing);
    json.key("count");
    json.count(path.samples.size());
    json.key("length");
    json.number(path.length);
    json.key("samples");
    json.beginArray();
    for (const auto& sample : path.samples) {
        json.beginObject(Flow::inLine);
        json.key("t");
        json.number(sample.t);
        json.key("length");
        json.number(sample.length);
        json.key("time");
        json.number(timeOf(sample, path));
        json.key("position");
        json.numbers(sample.position.coordinates());
        json.key("tangent");
        json.numbers(sample.tangent.coordinates());
        json.key("curvature");
        json.numberOrNull(sample.curvature);
        json.end();
    }
    json.end();
    json.end();
    return std::move(json).finished();
}

} // namespace splineloft
