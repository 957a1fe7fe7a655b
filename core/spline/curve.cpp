#include "core/spline/curve.h"

#include "core/spline/arrangement.h"
#include "core/spline/catalog.h"
#include "core/spline/problem.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace splineloft {
namespace {

/// The parameters of a spline as its family reads them: at the arranged places where local.
struct Settings {
    std::vector<double> parameters;
    std::vector<std::vector<double>> local;
    std::vector<double> weights; ///< of the places; none in families that use none
};

Settings settingsOf(const Spline& spline, const Arrangement& arrangement) {
    Settings settings{parametersOf(spline), {}, {}};
    const auto atPlaces = [&](const std::vector<double>& values) {
        std::vector<double> arranged;
        for (const auto& place : arrangement.places) {
            arranged.push_back(values.empty() ? 1 : values[place.control]);
        }
        return arranged;
    };
    for (const auto& parameter : familyOf(spline).parameters) {
        const auto given = spline.local.find(std::string(parameter.key));
        settings.local.push_back(given == spline.local.end() ? std::vector<double>()
                                                             : atPlaces(given->second));
    }
    if (familyOf(spline).usesWeights) {
        settings.weights = atPlaces(spline.weights);
        // Only ratios matter. The largest near 1 keeps coordinates from overflowing.
        const double unit = std::exp2(std::ilogb(std::ranges::max(settings.weights)));
        for (double& weight : settings.weights) {
            weight /= unit;
        }
    }
    return settings;
}

template <Blendable T>
Input<T> inputFor(const Spline& spline, const Arrangement& arrangement, const Settings& settings,
                  std::span<const T> points, std::span<const T> tangents) {
    return {points,
            tangents,
            arrangement.knots,
            settings.parameters,
            settings.local,
            arrangement.windows,
            arrangement.layout,
            spline.closed};
}

/// What is blended, place after place, each times its weight where there are weights.
template <Blendable T>
std::vector<T> weighted(const std::vector<Place>& places, std::span<const T> controls,
                        const std::vector<double>& weights) {
    auto values = arranged<T>(places, controls);
    for (std::size_t i = 0; i < weights.size(); ++i) {
        values[i] = weights[i] * values[i];
    }
    return values;
}

/// Unit recipes: exactly the control number first, first + 1, ...
std::vector<Blend> unitBlends(std::size_t first, std::size_t count) {
    std::vector<Blend> blends;
    for (std::size_t i = 0; i < count; ++i) {
        blends.push_back(Blend::of(first + i));
    }
    return blends;
}

/// One coordinate of all points; in place of a weight, the coordinate after the last, ones.
std::vector<double> column(const PointsView& table, int coordinate) {
    std::vector<double> values(table.size(), 1.0);
    for (std::size_t i = 0; i < table.size() && coordinate < table.dimension(); ++i) {
        values[i] = table(i, coordinate);
    }
    return values;
}

std::size_t bezierPoints(const Arrangement& arrangement) {
    return arrangement.pieces() * (static_cast<std::size_t>(arrangement.layout.degree) + 1);
}

void refuse(const std::optional<Problem>& problem) {
    if (problem) {
        throw std::invalid_argument("curve" + problem->place + " " + problem->what +
                                    "; right would be: " + problem->remedy);
    }
}

/// The pieces of a spline without problem.
Pieces blended(const Spline& spline, const PointsView& points, const PointsView& tangents) {
    const auto arrangement = arrangementOf(spline, points);
    const auto& layout = arrangement.layout;
    const int dimension = points.dimension();
    if (arrangement.pieces() == 0) {
        return {layout.degree, dimension, {}, {}, layout.form};
    }
    const auto& family = familyOf(spline);
    const auto settings = settingsOf(spline, arrangement);
    const auto count = bezierPoints(arrangement);
    const int width = dimension + (layout.form == Form::rational ? 1 : 0);
    const auto stride = static_cast<std::size_t>(width);
    std::vector<double> bezier(count * stride);
    std::vector<double> one(count);
    for (int c = 0; c < width; ++c) {
        const auto own = weighted<double>(arrangement.places, column(points, c), settings.weights);
        std::vector<double> ownTangents;
        if (family.usesTangents) {
            ownTangents = arranged<double>(arrangement.places, column(tangents, c));
        }
        family.blendCoordinates(inputFor<double>(spline, arrangement, settings, own, ownTangents),
                                {0, arrangement.pieces()}, one);
        for (std::size_t i = 0; i < count; ++i) {
            bezier[i * stride + static_cast<std::size_t>(c)] = one[i];
        }
    }
    return {layout.degree, dimension, arrangement.joints, std::move(bezier), layout.form};
}

} // namespace

const Family& familyOf(const Spline& spline) {
    const Family* family = findFamily(spline.family);
    if (family == nullptr) {
        throw std::invalid_argument("there is no spline family \"" + spline.family + "\"");
    }
    return *family;
}

std::vector<double> parametersOf(const Spline& spline) {
    std::vector<double> values;
    for (const auto& parameter : familyOf(spline).parameters) {
        values.push_back(parameterOf(spline, parameter.key));
    }
    return values;
}

double parameterOf(const Spline& spline, std::string_view key) {
    const auto& parameters = familyOf(spline).parameters;
    const auto found = std::ranges::find(parameters, key, &Parameter::key);
    if (found == parameters.end()) {
        throw std::invalid_argument("the family " + spline.family + " has no parameter \"" +
                                    std::string(key) + "\"");
    }
    const auto given = spline.parameters.find(std::string(key));
    return given == spline.parameters.end() ? found->neutral : given->second;
}

void completeParameters(Spline& spline) {
    for (const auto& parameter : familyOf(spline).parameters) {
        spline.parameters.try_emplace(std::string(parameter.key), parameter.neutral);
    }
}

bool knotsFollowPoints(const Spline& spline) {
    return familyOf(spline).spacing != Spacing::uniform && spline.knots.empty() &&
           parameterOf(spline, "alpha") != 0;
}

Layout layoutOf(const Spline& spline, std::size_t points) {
    return familyOf(spline).layout({parametersOf(spline), points, !spline.local.empty()});
}

std::size_t fewestPoints(const Spline& spline) {
    Spline trial = spline;
    if (!trial.knots.empty()) { // which belong to another number of points
        trial.knots.clear();
        trial.ends = Ends::open;
    }
    Points points(1);
    do {
        points.append(Point(1));
    } while (arrangementOf(trial, points).pieces() == 0);
    return points.size();
}

Pieces piecesOf(const Spline& spline, const PointsView& points, const PointsView& tangents) {
    refuse(problemOf(spline, points, tangents));
    return blended(spline, points, tangents);
}

Pieces piecesOf(const Curve& curve) {
    refuse(problemOf(curve));
    return blended(curve, curve.points, curve.tangents);
}

BlendPieces blendsOf(const Spline& spline, const PointsView& points, const PointsView& tangents) {
    refuse(problemOf(spline, points, tangents));
    const auto arrangement = arrangementOf(spline, points);
    const auto& layout = arrangement.layout;
    const auto n = points.size();
    if (arrangement.pieces() == 0) {
        return {layout.degree, n, {}, {}, layout.form};
    }
    const auto& family = familyOf(spline);
    const auto settings = settingsOf(spline, arrangement);
    const auto own = weighted<Blend>(arrangement.places, unitBlends(0, n), settings.weights);
    std::vector<Blend> ownTangents;
    if (family.usesTangents) {
        ownTangents = arranged<Blend>(arrangement.places, unitBlends(n, n));
    }
    std::vector<Blend> bezier(bezierPoints(arrangement));
    family.blendRecipes(inputFor<Blend>(spline, arrangement, settings, own, ownTangents),
                        {0, arrangement.pieces()}, bezier);
    return {layout.degree, n, arrangement.joints, std::move(bezier), layout.form};
}

BlendPieces blendsOf(const Curve& curve) {
    return blendsOf(curve, curve.points, curve.tangents);
}

std::size_t controlAtStart(const Curve& curve, std::size_t segment) {
    const auto arrangement = arrangementOf(curve, curve.points);
    const auto& places = arrangement.places;
    if (places.empty()) {
        return 0;
    }
    const auto window =
        segment < arrangement.pieces() ? arrangement.windows[segment] : places.size();
    const auto at = window + static_cast<std::size_t>(arrangement.layout.lead);
    return places[std::min(at, places.size() - 1)].control;
}

std::vector<double> abscissae(const Curve& curve) {
    const auto arrangement = arrangementOf(curve, curve.points);
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
