#include "core/spline/curve.h"

#include "core/spline/arrangement.h"
#include "core/spline/catalog.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace splineloft {
namespace {

std::string shortest(double value) {
    std::array<char, 32> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
    return {text.data(), end};
}

/// "a", "b" or "c", from any range of named things.
template <class Range, class Name> std::string choice(const Range& range, Name name) {
    std::string words;
    for (const auto& item : range) {
        words += (words.empty() ? "" : ", ") + std::string(name(item));
    }
    return words;
}

std::optional<Problem> parameterProblem(const Curve& curve, const Family& family) {
    for (const auto& [key, value] : curve.parameters) {
        const std::string place = "/parameters/" + key;
        const auto found = std::ranges::find(family.parameters, key, &Parameter::key);
        if (found == family.parameters.end()) {
            return Problem{
                place, "the family " + curve.family + " has no parameter \"" + key + "\"",
                family.parameters.empty()
                    ? "leave it out"
                    : "use " + choice(family.parameters, [](const auto& p) { return p.key; })};
        }
        const bool whole = found->scale != Scale::whole || value == std::floor(value);
        if (!(value >= found->least && value <= found->most) || !whole) {
            return Problem{
                place, "is " + shortest(value),
                std::string(found->scale == Scale::whole ? "a whole number" : "a number") +
                    " from " + shortest(found->least) + " to " + shortest(found->most)};
        }
    }
    return std::nullopt;
}

std::optional<Problem> tableProblem(const Points& table, const Curve& curve,
                                    const std::string& place) {
    if (table.dimension() != curve.points.dimension()) {
        return Problem{place, "has " + std::to_string(table.dimension()) + " coordinates",
                       "as many as the points have: " + std::to_string(curve.points.dimension())};
    }
    const auto values = table.values();
    const auto bad = std::ranges::find_if(values, [](double v) { return !std::isfinite(v); });
    if (bad == values.end()) {
        return std::nullopt;
    }
    const auto at = bad - values.begin();
    return Problem{place + "/" + std::to_string(at / table.dimension()) + "/" +
                       std::to_string(at % table.dimension()),
                   "is not a finite number", "a finite number"};
}

std::optional<Problem> coordinatesProblem(const Curve& curve) {
    const int dimension = curve.points.dimension();
    if (dimension < 1 || dimension > maxDimension) {
        return Problem{"/points", "points have " + std::to_string(dimension) + " coordinates",
                       "1 to " + std::to_string(maxDimension) + " coordinates"};
    }
    if (curve.coordinates.size() != static_cast<std::size_t>(dimension)) {
        return Problem{"/coordinates",
                       "names " + std::to_string(curve.coordinates.size()) +
                           " coordinates where the "
                           "points have " +
                           std::to_string(dimension),
                       "one name for each coordinate"};
    }
    for (std::size_t i = 0; i < curve.coordinates.size(); ++i) {
        const auto& name = curve.coordinates[i];
        if (name.empty() || std::ranges::count(curve.coordinates, name) > 1) {
            return Problem{"/coordinates/" + std::to_string(i),
                           name.empty() ? "is empty" : "stands twice: \"" + name + "\"",
                           "a name of its own for each coordinate"};
        }
    }
    return std::nullopt;
}

std::optional<Problem> tangentsProblem(const Curve& curve, const Family& family) {
    if (!family.usesTangents) {
        return curve.tangents.empty()
                   ? std::nullopt
                   : std::optional(Problem{"/tangents",
                                           "the family " + curve.family + " takes no tangents",
                                           "leave them out, or use the family hermite"});
    }
    if (curve.tangents.size() != curve.points.size()) {
        return Problem{"/tangents",
                       "has " + std::to_string(curve.tangents.size()) + " tangents for " +
                           std::to_string(curve.points.size()) + " points",
                       "one tangent for each point"};
    }
    return tableProblem(curve.tangents, curve, "/tangents");
}

/// What the families blend, one control after another: unit recipes for points and tangents.
std::vector<Blend> unitBlends(std::size_t first, std::size_t count) {
    std::vector<Blend> blends;
    for (std::size_t i = 0; i < count; ++i) {
        blends.push_back(Blend::of(first + i));
    }
    return blends;
}

template <Blendable T>
Input<T> inputFor(const Curve& curve, const Arrangement& arrangement, std::span<const T> points,
                  std::span<const T> tangents, std::span<const double> parameters) {
    return {points, tangents, arrangement.knots, parameters, arrangement.layout, curve.closed};
}

std::vector<double> column(const Points& table, int coordinate) {
    std::vector<double> values;
    values.reserve(table.size());
    for (std::size_t i = 0; i < table.size(); ++i) {
        values.push_back(table[i][static_cast<std::size_t>(coordinate)]);
    }
    return values;
}

} // namespace

std::optional<Problem> problemOf(const Curve& curve) {
    const Family* family = findFamily(curve.family);
    if (family == nullptr) {
        return Problem{"/family", "there is no family \"" + curve.family + "\"",
                       "one of " + choice(catalog(), [](const auto& f) { return f.id; })};
    }
    if (curve.points.size() > family->mostPoints) {
        return Problem{"/points", "has " + std::to_string(curve.points.size()) + " points",
                       "at most " + std::to_string(family->mostPoints) + " points for the family " +
                           curve.family};
    }
    if (curve.closed && !family->closable) {
        return Problem{"/closed", "a curve of the family " + curve.family + " cannot be closed",
                       "false, or another family"};
    }
    const bool endsMatter = !(curve.closed && curve.ends == Ends::none);
    if (endsMatter && std::ranges::find(family->ends, curve.ends) == family->ends.end()) {
        return Problem{"/ends", "is \"" + std::string(nameOf(curve.ends)) + "\"",
                       "for the family " + curve.family + ": " +
                           choice(family->ends, [](Ends e) { return nameOf(e); })};
    }
    if (auto problem = coordinatesProblem(curve)) {
        return problem;
    }
    if (auto problem = tableProblem(curve.points, curve, "/points")) {
        return problem;
    }
    if (auto problem = tangentsProblem(curve, *family)) {
        return problem;
    }
    return parameterProblem(curve, *family);
}

const Family& familyOf(const Curve& curve) {
    const Family* family = findFamily(curve.family);
    if (family == nullptr) {
        throw std::invalid_argument("there is no spline family \"" + curve.family + "\"");
    }
    return *family;
}

std::vector<double> parametersOf(const Curve& curve) {
    std::vector<double> values;
    for (const auto& parameter : familyOf(curve).parameters) {
        const auto given = curve.parameters.find(std::string(parameter.key));
        values.push_back(given == curve.parameters.end() ? parameter.neutral : given->second);
    }
    return values;
}

void completeParameters(Curve& curve) {
    for (const auto& parameter : familyOf(curve).parameters) {
        curve.parameters.try_emplace(std::string(parameter.key), parameter.neutral);
    }
}

Layout layoutOf(const Curve& curve) {
    return familyOf(curve).layout(parametersOf(curve), curve.points.size());
}

std::size_t fewestPoints(const Curve& curve) {
    Curve trial = curve;
    trial.points = Points(curve.points.dimension());
    trial.tangents = trial.points;
    std::size_t count = 0;
    do {
        trial.points.append(Point(curve.points.dimension()));
        ++count;
    } while (arrangementOf(trial).pieces == 0);
    return count;
}

Pieces piecesOf(const Curve& curve) {
    if (const auto problem = problemOf(curve)) {
        throw std::invalid_argument("curve" + problem->place + " " + problem->what +
                                    "; right would be: " + problem->remedy);
    }
    const auto arrangement = arrangementOf(curve);
    const int dimension = curve.points.dimension();
    if (arrangement.pieces == 0) {
        return {arrangement.layout.degree, dimension, {}, {}};
    }
    const auto& family = familyOf(curve);
    const auto parameters = parametersOf(curve);
    const auto count =
        arrangement.pieces * (static_cast<std::size_t>(arrangement.layout.degree) + 1);
    const auto stride = static_cast<std::size_t>(dimension);
    std::vector<double> bezier(count * stride);
    std::vector<double> one(count);
    for (int c = 0; c < dimension; ++c) {
        const auto points = arranged<double>(arrangement.places, column(curve.points, c));
        std::vector<double> tangents;
        if (family.usesTangents) {
            tangents = arranged<double>(arrangement.places, column(curve.tangents, c));
        }
        family.blendCoordinates(inputFor<double>(curve, arrangement, points, tangents, parameters),
                                {0, arrangement.pieces}, one);
        for (std::size_t i = 0; i < count; ++i) {
            bezier[i * stride + static_cast<std::size_t>(c)] = one[i];
        }
    }
    return {arrangement.layout.degree, dimension, arrangement.joints, std::move(bezier)};
}

BlendPieces blendsOf(const Curve& curve) {
    const auto arrangement = arrangementOf(curve);
    const auto n = curve.points.size();
    if (arrangement.pieces == 0) {
        return {arrangement.layout.degree, n, {}, {}};
    }
    const auto& family = familyOf(curve);
    const auto parameters = parametersOf(curve);
    const auto points = arranged<Blend>(arrangement.places, unitBlends(0, n));
    std::vector<Blend> tangents;
    if (family.usesTangents) {
        tangents = arranged<Blend>(arrangement.places, unitBlends(n, n));
    }
    std::vector<Blend> bezier(arrangement.pieces *
                              (static_cast<std::size_t>(arrangement.layout.degree) + 1));
    family.blendRecipes(inputFor<Blend>(curve, arrangement, points, tangents, parameters),
                        {0, arrangement.pieces}, bezier);
    return {arrangement.layout.degree, n, arrangement.joints, std::move(bezier)};
}

std::size_t controlAtStart(const Curve& curve, std::size_t segment) {
    const auto arrangement = arrangementOf(curve);
    const auto& layout = arrangement.layout;
    const auto at =
        segment * static_cast<std::size_t>(layout.stride) + static_cast<std::size_t>(layout.lead);
    if (arrangement.places.empty()) {
        return 0;
    }
    return arrangement.places[std::min(at, arrangement.places.size() - 1)].control;
}

std::vector<double> abscissae(const Curve& curve) {
    const auto arrangement = arrangementOf(curve);
    const auto& layout = arrangement.layout;
    const auto& knots = arrangement.knots;
    const auto degree = static_cast<std::size_t>(layout.degree);
    const bool knotVector = familyOf(curve).spacing == Spacing::knotVector;
    std::vector<double> values;
    for (std::size_t i = 0; i < curve.points.size(); ++i) {
        const auto place = arrangement.before + i;
        if (layout.stride > 1 || knots.empty()) {
            values.push_back(static_cast<double>(i) / std::max(1, layout.window - 1));
        } else if (knotVector) {
            const auto inner = std::span(knots).subspan(place + 1, degree);
            values.push_back(std::accumulate(inner.begin(), inner.end(), 0.0) / layout.degree);
        } else {
            values.push_back(knots[place]);
        }
    }
    return values;
}

} // namespace splineloft
