#include "core/spline/blending.h"

#include <algorithm>
#include <cmath>

namespace splineloft {

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

} // namespace splineloft
