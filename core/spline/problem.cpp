#include "core/spline/problem.h"

#include "core/spline/algebra/scale.h"
#include "core/spline/catalog.h"
#include "core/spline/digits.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace splineloft {
namespace {

// Beyond these a weight, or the interval between two knots, has no effect that a double could hold.
constexpr double leastWeight = 1e-9;
constexpr double mostWeight = 1e9;
constexpr double mostKnot = 1e300;

// Longest key spelled out in a JSON pointer, in bytes.
constexpr std::size_t longestToken = 80;

std::string counted(std::size_t count, const std::string& noun) {
    return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

/// "a", "b" or "c", from any range of named things.
template <class Range, class Name> std::string choice(const Range& range, Name name) {
    std::string words;
    for (const auto& item : range) {
        words += (words.empty() ? "" : ", ") + std::string(name(item));
    }
    return words;
}

constexpr auto keyOf = [](const Parameter& parameter) { return parameter.key; };

/// "is 3", or that it is none that could be written.
std::string isWords(double value) {
    return std::isfinite(value) ? "is " + allDigits(value) : "is not a finite number";
}

/// What is wrong with the value of a parameter.
std::optional<Problem> valueProblem(const Parameter& parameter, double value,
                                    const std::string& place) {
    const bool whole = parameter.scale != Scale::whole || value == std::floor(value);
    if (value >= parameter.least && value <= parameter.most && whole) {
        return std::nullopt;
    }
    return Problem{place, isWords(value),
                   std::string(parameter.scale == Scale::whole ? "a whole number" : "a number") +
                       " from " + allDigits(parameter.least) + " to " + allDigits(parameter.most)};
}

std::optional<Problem> parameterProblem(const Spline& spline, const Family& family) {
    for (const auto& [key, value] : spline.parameters) {
        const std::string place = "/parameters" + pointerToken(key);
        const auto found = std::ranges::find(family.parameters, key, &Parameter::key);
        if (found == family.parameters.end()) {
            return Problem{place,
                           "the family " + spline.family + " has no parameter \"" + key + "\"",
                           family.parameters.empty() ? "leave it out"
                                                     : "use " + choice(family.parameters, keyOf)};
        }
        if (auto problem = valueProblem(*found, value, place)) {
            return problem;
        }
    }
    return std::nullopt;
}

std::optional<Problem> localProblem(const Spline& spline, const Family& family,
                                    std::size_t points) {
    for (const auto& [key, values] : spline.local) {
        const std::string place = "/local" + pointerToken(key);
        const auto found = std::ranges::find(family.parameters, key, &Parameter::key);
        if (found == family.parameters.end() || !found->local) {
            std::vector<Parameter> local;
            std::ranges::copy_if(family.parameters, std::back_inserter(local), &Parameter::local);
            return Problem{place,
                           "the family " + spline.family + " has no \"" + key +
                               "\" at each control point",
                           local.empty() ? "leave it out" : "use " + choice(local, keyOf)};
        }
        if (values.size() != points) {
            return Problem{place,
                           "has " + counted(values.size(), "value") + " for " +
                               counted(points, "point"),
                           "one value for each point"};
        }
        for (std::size_t i = 0; i < values.size(); ++i) {
            if (auto problem = valueProblem(*found, values[i], place + pointerToken(i))) {
                return problem;
            }
        }
    }
    return std::nullopt;
}

std::optional<Problem> weightsProblem(const Spline& spline, const Family& family,
                                      std::size_t points) {
    const auto& weights = spline.weights;
    if (weights.empty()) {
        return std::nullopt;
    }
    if (!family.usesWeights) {
        return Problem{"/weights", "the family " + spline.family + " takes no weights",
                       "leave them out, or use the family nurbs"};
    }
    if (weights.size() != points) {
        return Problem{"/weights",
                       "has " + counted(weights.size(), "weight") + " for " +
                           counted(points, "point"),
                       "one weight for each point"};
    }
    const auto bad = std::ranges::find_if(
        weights, [](double w) { return !(w >= leastWeight && w <= mostWeight); });
    if (bad == weights.end()) {
        return std::nullopt;
    }
    return Problem{"/weights/" + std::to_string(bad - weights.begin()), isWords(*bad),
                   "a number from " + allDigits(leastWeight) + " to " + allDigits(mostWeight)};
}

/// What is wrong with the order of the knots, each of which may stand `most` times.
std::optional<Problem> orderProblem(std::span<const double> knots, std::size_t most) {
    std::size_t times = 0;
    for (std::size_t i = 0; i < knots.size(); ++i) {
        const auto place = [i] { return "/knots/" + std::to_string(i); };
        if (!(std::abs(knots[i]) <= mostKnot)) {
            return Problem{place(), "is " + allDigits(knots[i]),
                           "a number from " + allDigits(-mostKnot) + " to " + allDigits(mostKnot)};
        }
        if (i > 0 && knots[i] < knots[i - 1]) {
            return Problem{place(),
                           "falls from " + allDigits(knots[i - 1]) + " to " + allDigits(knots[i]),
                           "knots that never fall"};
        }
        times = i > 0 && knots[i] == knots[i - 1] ? times + 1 : 1;
        if (times > most) {
            return Problem{place(),
                           allDigits(knots[i]) + " stands more than " + counted(most, "time"),
                           "each knot at most " + counted(most, "time")};
        }
    }
    return std::nullopt;
}

std::optional<Problem> knotsProblem(const Spline& spline, const Family& family,
                                    std::size_t points) {
    const auto& knots = spline.knots;
    if (knots.empty()) {
        return std::nullopt;
    }
    if (!family.usesKnots) {
        return Problem{"/knots", "the family " + spline.family + " takes no knots",
                       "leave them out, or use the family b-spline"};
    }
    const auto degree = static_cast<std::size_t>(parameterOf(spline, "degree"));
    const auto wanted = points + (spline.closed ? 1 : degree + 1);
    if (knots.size() != wanted) {
        return Problem{"/knots",
                       "has " + counted(knots.size(), "knot") + " for " + counted(points, "point") +
                           " and degree " + std::to_string(degree),
                       counted(wanted, "knot")};
    }
    if (auto problem = orderProblem(knots, spline.closed ? degree : degree + 1)) {
        return problem;
    }
    const bool empty = spline.closed ? !(knots.front() < knots.back())
                                     : points > degree && !(knots[degree] < knots[points]);
    if (empty) {
        return Problem{"/knots", "leave no interval for the curve",
                       spline.closed ? "a first knot below the last"
                                     : "knot " + std::to_string(degree) + " below knot " +
                                           std::to_string(points)};
    }
    return std::nullopt;
}

std::optional<Problem> endsProblem(const Spline& spline, const Family& family) {
    if (spline.closed && !family.closable) {
        return Problem{"/closed", "a curve of the family " + spline.family + " cannot be closed",
                       "false, or another family"};
    }
    if (spline.closed && spline.ends == Ends::none) {
        return std::nullopt;
    }
    const bool ownKnots = family.usesKnots && !spline.knots.empty();
    const auto accepted = ownKnots ? std::vector{Ends::none} : family.ends;
    if (std::ranges::find(accepted, spline.ends) != accepted.end()) {
        return std::nullopt;
    }
    return Problem{"/ends", "is \"" + std::string(nameOf(spline.ends)) + "\"",
                   "for the family " + spline.family +
                       (ownKnots ? " with knots of its own: " : ": ") +
                       choice(accepted, [](Ends e) { return nameOf(e); })};
}

std::optional<Problem> tableProblem(const PointsView& table, int dimension, double most,
                                    const std::string& place) {
    if (table.dimension() != dimension) {
        return Problem{place, "has " + std::to_string(table.dimension()) + " coordinates",
                       "as many as the points have: " + std::to_string(dimension)};
    }
    if (const auto rows = table.rows(); !rows.empty() && allWithin(rows, most)) {
        return std::nullopt;
    }
    for (std::size_t i = 0; i < table.size(); ++i) {
        for (int c = 0; c < dimension; ++c) {
            const double value = table(i, c);
            if (std::abs(value) <= most) {
                continue;
            }
            return Problem{place + pointerToken(i) + pointerToken(static_cast<std::size_t>(c)),
                           isWords(value),
                           std::isfinite(value)
                               ? "a number from " + allDigits(-most) + " to " + allDigits(most)
                               : "a finite number"};
        }
    }
    return std::nullopt;
}

std::optional<Problem> tangentsProblem(const Spline& spline, const Family& family,
                                       const PointsView& points, const PointsView& tangents) {
    if (!family.usesTangents) {
        return tangents.empty()
                   ? std::nullopt
                   : std::optional(Problem{"/tangents",
                                           "the family " + spline.family + " takes no tangents",
                                           "leave them out, or use the family hermite"});
    }
    if (tangents.size() != points.size()) {
        return Problem{"/tangents",
                       "has " + counted(tangents.size(), "tangent") + " for " +
                           counted(points.size(), "point"),
                       "one tangent for each point"};
    }
    return tableProblem(tangents, points.dimension(), family.mostCoordinate, "/tangents");
}

std::optional<Problem> dimensionProblem(const PointsView& points) {
    const int dimension = points.dimension();
    if (dimension >= 1 && dimension <= maxDimension) {
        return std::nullopt;
    }
    return Problem{"/points", "points have " + std::to_string(dimension) + " coordinates",
                   "1 to " + std::to_string(maxDimension) + " coordinates"};
}

std::optional<Problem> namesProblem(const std::vector<std::string>& names, int dimension) {
    if (names.size() != static_cast<std::size_t>(dimension)) {
        return Problem{"/coordinates",
                       "names " + counted(names.size(), "coordinate") + " where the points have " +
                           std::to_string(dimension),
                       "one name for each coordinate"};
    }
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (names[i].empty() || std::ranges::count(names, names[i]) > 1) {
            return Problem{"/coordinates/" + std::to_string(i),
                           names[i].empty() ? "is empty" : "stands twice: \"" + names[i] + "\"",
                           "a name of its own for each coordinate"};
        }
    }
    return std::nullopt;
}

/// The family, and how many points it takes.
std::optional<Problem> familyProblem(const Spline& spline, const Family* family,
                                     std::size_t points) {
    if (family == nullptr) {
        return Problem{"/family", "there is no family \"" + spline.family + "\"",
                       "one of " + choice(catalog(), [](const auto& f) { return f.id; })};
    }
    if (points > family->mostPoints) {
        return Problem{"/points", "has " + counted(points, "point"),
                       "at most " + std::to_string(family->mostPoints) + " points for the family " +
                           spline.family};
    }
    return std::nullopt;
}

} // namespace

std::string pointerToken(std::string_view key) {
    std::string token = "/";
    for (const char c : key.substr(0, longestToken)) {
        if (c == '~' || c == '/') {
            token += c == '~' ? "~0" : "~1";
        } else {
            token += c;
        }
    }
    return key.size() > longestToken ? token + "..." : token;
}

std::string pointerToken(std::size_t index) {
    return pointerToken(std::to_string(index));
}

std::optional<Problem> problemOf(const Spline& spline, const PointsView& points,
                                 const PointsView& tangents) {
    const Family* family = findFamily(spline.family);
    auto problem = familyProblem(spline, family, points.size());
    const auto then = [&](auto next) {
        if (!problem) {
            problem = next();
        }
    };
    then([&] { return endsProblem(spline, *family); });
    then([&] { return dimensionProblem(points); });
    then([&] { return placesProblem(spline, points, tangents); });
    then([&] { return parameterProblem(spline, *family); });
    then([&] { return localProblem(spline, *family, points.size()); });
    then([&] { return weightsProblem(spline, *family, points.size()); });
    then([&] { return knotsProblem(spline, *family, points.size()); });
    return problem;
}

std::optional<Problem> placesProblem(const Spline& spline, const PointsView& points,
                                     const PointsView& tangents) {
    const Family& family = familyOf(spline);
    auto problem = tableProblem(points, points.dimension(), family.mostCoordinate, "/points");
    return problem ? problem : tangentsProblem(spline, family, points, tangents);
}

std::optional<Problem> problemOf(const Curve& curve) {
    const auto problem = problemOf(curve, PointsView(curve.points), PointsView(curve.tangents));
    return problem ? problem : namesProblem(curve.coordinates, curve.points.dimension());
}

std::variant<Curve, Problem> checked(Curve curve) {
    if (auto problem = problemOf(curve)) {
        return *problem;
    }
    return curve;
}

} // namespace splineloft
