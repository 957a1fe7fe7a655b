#include "core/document/document.h"

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
    const auto far =
        std::ranges::find_if(values, [](double v) { return std::abs(v) > largestCoordinate; });
    if (far == values.end()) {
        return std::nullopt;
    }
    const auto at = far - values.begin();
    return Problem{place + "/" + std::to_string(at / table.dimension()) + "/" +
                       std::to_string(at % table.dimension()),
                   "is too large a coordinate", "a number from -1e9 to 1e9"};
}

} // namespace

bool CurveEntry::operator==(const CurveEntry& other) const {
    return look == other.look && handleModes == other.handleModes &&
           (curve == other.curve || *curve == *other.curve);
}

std::optional<Problem> problemOf(const Document& document) {
    for (std::size_t i = 0; i < document.curves.size(); ++i) {
        const Curve& curve = *document.curves[i];
        auto problem = problemOf(curve);
        if (!problem) {
            problem = limitProblem(curve.points, "/points");
        }
        if (!problem) {
            problem = limitProblem(curve.tangents, "/tangents");
        }
        if (problem) {
            problem->place = "/curves/" + std::to_string(i) + problem->place;
            return problem;
        }
    }
    return std::nullopt;
}

} // namespace splineloft
