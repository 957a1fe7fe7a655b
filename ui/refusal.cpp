#include "ui/refusal.h"

#include "core/spline/catalog.h"
#include "ui/canvas/wording.h"

#include <algorithm>
#include <optional>
#include <string_view>
#include <vector>

namespace splineloft::ui {
namespace {

using Tokens = std::vector<std::string>;

Tokens tokensOf(std::string_view pointer) {
    Tokens tokens;
    while (!pointer.empty()) {
        pointer.remove_prefix(1); // the slash
        const auto end = std::min(pointer.find('/'), pointer.size());
        tokens.emplace_back(pointer.substr(0, end));
        pointer.remove_prefix(end);
    }
    return tokens;
}

/// A token that is a number below a bound.
std::optional<std::size_t> indexOf(const std::string& token, std::size_t count) {
    if (token.empty() || token.size() > 9 || token.find_first_not_of("0123456789") != token.npos) {
        return std::nullopt;
    }
    const std::size_t index = std::stoul(token);
    return index < count ? std::optional(index) : std::nullopt;
}

/// The label of the family's parameter, else its key.
std::string parameterName(const Curve& curve, const std::string& key) {
    const auto& parameters = familyOf(curve).parameters;
    const auto found = std::ranges::find(parameters, key, &Parameter::key);
    return found == parameters.end() ? key : std::string(found->label);
}

/// The place within a curve: "y of P₃", "Tension", "weight of P₂".
std::string placeIn(const Curve& curve, const Tokens& tokens) {
    const auto& kind = tokens.front();
    const bool isParameter = kind == "parameters" || kind == "local";
    const std::size_t at = isParameter ? 2 : 1; // where the number of a point would stand
    const auto point = tokens.size() > at ? indexOf(tokens[at], curve.points.size()) : std::nullopt;
    std::string name = isParameter && tokens.size() > 1 ? parameterName(curve, tokens[1])
                       : kind == "weights"              ? "weight"
                                                        : "";
    if (!point || kind == "knots" || kind == "coordinates") {
        return name.empty() ? kind : name;
    }
    const auto axis = tokens.size() > 2 ? indexOf(tokens[2], curve.coordinates.size())
                                        : std::optional<std::size_t>();
    if (axis && !isParameter) {
        name = curve.coordinates[*axis];
    }
    return (name.empty() ? "" : name + " of ") + (kind == "tangents" ? "the tangent at " : "") +
           plainPointName(*point);
}

std::string placeWords(const std::string& pointer, const Document& document) {
    Tokens tokens = tokensOf(pointer);
    const bool inCurve = tokens.size() > 2 && tokens.front() == "curves";
    const auto curve = inCurve ? indexOf(tokens[1], document.curves.size()) : std::nullopt;
    if (!curve) {
        return pointer;
    }
    tokens.erase(tokens.begin(), tokens.begin() + 2);
    return placeIn(*document.curves[*curve], tokens);
}

} // namespace

std::string refusalOf(const std::string& deed, const Problem& problem, const Document& document) {
    return (deed.empty() ? "This" : deed) +
           " is not possible: " + placeWords(problem.place, document) + " " + problem.what +
           "; right would be: " + problem.remedy;
}

} // namespace splineloft::ui
