#include "core/document/document.h"

#include "core/spline/algebra/scale.h"

#include <algorithm>
#include <cmath>

namespace splineloft {
namespace {

std::optional<Problem> limitProblem(const Points& table, const std::string& place) {
    if (table.size() > mostPointsOfACurve) {
        return Problem{place, "has " + std::to_string(table.size()) + " rows",
                       "at most " + std::to_string(mostPointsOfACurve)};
    }
    const auto values = table.values();
    if (allWithin(values, largestCoordinate)) {
        return std::nullopt;
    }
    const auto far =
        std::ranges::find_if(values, [](double v) { return std::abs(v) > largestCoordinate; });
    const auto at = far - values.begin();
    return Problem{place + "/" + std::to_string(at / table.dimension()) + "/" +
                       std::to_string(at % table.dimension()),
                   "is too large a coordinate", "a number from -1e9 to 1e9"};
}

/// Limits of the places of points and tangents, apart from the family's.
std::optional<Problem> limitProblem(const Curve& curve) {
    const auto problem = limitProblem(curve.points, "/points");
    return problem ? problem : limitProblem(curve.tangents, "/tangents");
}

std::optional<Problem> problemWith(const Curve& curve) {
    const auto problem = problemOf(curve);
    return problem ? problem : limitProblem(curve);
}

std::optional<Problem> placesProblem(const Curve& curve) {
    const double most = std::min(familyOf(curve).mostCoordinate, largestCoordinate);
    if (allWithin(curve.points.values(), most) && allWithin(curve.tangents.values(), most)) {
        return std::nullopt; // one look at all of them, as at every step of a drag
    }
    const auto problem = placesProblem(curve, curve.points, curve.tangents);
    return problem ? problem : limitProblem(curve);
}

} // namespace

bool CurveEntry::operator==(const CurveEntry& other) const {
    return look == other.look && handleModes == other.handleModes &&
           (curve == other.curve || *curve == *other.curve);
}

std::optional<Problem> problemOf(const Document& document) {
    return problemOf(document, {});
}

std::optional<Problem> problemOf(const Document& document, const Document& sound) {
    for (std::size_t i = 0; i < document.curves.size(); ++i) {
        const auto& curve = document.curves[i];
        const auto* before = i < sound.curves.size() ? &sound.curves[i] : nullptr;
        if (before != nullptr && before->curve == curve.curve) {
            continue;
        }
        const bool onlyMoved = before != nullptr && differInPlacesAlone(**before, *curve);
        if (auto problem = onlyMoved ? placesProblem(*curve) : problemWith(*curve)) {
            problem->place = "/curves/" + std::to_string(i) + problem->place;
            return problem;
        }
    }
    return std::nullopt;
}

} // namespace splineloft
