#include "core/spline/curve.h"

#include "core/spline/arrangement.h"
#include "core/spline/blending.h"
#include "core/spline/catalog.h"
#include "core/spline/live_pieces.h"
#include "core/spline/problem.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>

namespace splineloft {
namespace {

/// Unit recipes: exactly the control number first, first + 1, ...
std::vector<Blend> unitBlends(std::size_t first, std::size_t count) {
    std::vector<Blend> blends;
    for (std::size_t i = 0; i < count; ++i) {
        blends.push_back(Blend::of(first + i));
    }
    return blends;
}

void refuse(const std::optional<Problem>& problem) {
    if (problem) {
        throw std::invalid_argument("curve" + problem->place + " " + problem->what +
                                    "; right would be: " + problem->remedy);
    }
}

/// Some of the pieces as blends of n control points.
BlendPieces blendsOf(const Spline& spline, std::size_t n, const Arrangement& arrangement,
                     const Range& range) {
    const auto& layout = arrangement.layout;
    if (range.size() == 0) {
        return {layout.degree, n, {}, {}, layout.form};
    }
    const auto& family = familyOf(spline);
    const auto settings = settingsOf(spline, arrangement);
    auto own = arranged<Blend>(arrangement.places, unitBlends(0, n));
    for (std::size_t i = 0; i < settings.weights.size(); ++i) {
        own[i] = settings.weights[i] * own[i];
    }
    std::vector<Blend> ownTangents;
    if (family.usesTangents) {
        ownTangents = arranged<Blend>(arrangement.places, unitBlends(n, n));
    }
    std::vector<Blend> bezier(range.size() * bezierPointsOf(layout));
    family.blendRecipes(inputFor<Blend>(spline.closed, arrangement, settings, own, ownTangents),
                        range, bezier);
    const auto knots = arrangement.joints.knots().subspan(range.first, range.size() + 1);
    return {layout.degree, n, KnotLine({knots.begin(), knots.end()}), std::move(bezier),
            layout.form};
}

} // namespace

bool differInPlacesAlone(const Curve& a, const Curve& b) {
    const auto alike = [](const Points& one, const Points& other) {
        return one.size() == other.size() && one.dimension() == other.dimension();
    };
    return static_cast<const Spline&>(a) == b && a.name == b.name &&
           a.coordinates == b.coordinates && alike(a.points, b.points) &&
           alike(a.tangents, b.tangents);
}

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
    return LivePieces(spline, points, tangents).take();
}

Pieces piecesOf(const Curve& curve) {
    refuse(problemOf(curve));
    return LivePieces(curve, curve.points, curve.tangents).take();
}

BlendPieces blendsOf(const Spline& spline, const PointsView& points, const PointsView& tangents) {
    refuse(problemOf(spline, points, tangents));
    const auto arrangement = arrangementOf(spline, points);
    return blendsOf(spline, points.size(), arrangement, {0, arrangement.pieces()});
}

BlendPieces blendsOf(const Curve& curve) {
    return blendsOf(curve, curve.points, curve.tangents);
}

BlendPieces blendsOfPiece(const Curve& curve, std::size_t segment) {
    refuse(problemOf(curve));
    const auto arrangement = arrangementOf(curve, curve.points);
    return blendsOf(curve, curve.points.size(), arrangement, {segment, segment + 1});
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
