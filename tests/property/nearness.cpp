#include "tests/property/nearness.h"

#include "core/spline/measure/nearest.h"

#include <algorithm>

namespace splineloft::testing_curves {

double farthestFrom(const Pieces& one, const Pieces& other) {
    constexpr int steps = 16;
    const NearestIndex index(other);
    double farthest = 0;
    for (std::size_t i = 0; i < one.size(); ++i) {
        for (int k = 0; k <= steps; ++k) {
            const Point place = one.position({i, static_cast<double>(k) / steps});
            farthest = std::max(farthest, index.nearest(place)->distance);
        }
    }
    return farthest;
}

double farthestApart(const Pieces& one, const Pieces& other) {
    return std::max(farthestFrom(one, other), farthestFrom(other, one));
}

} // namespace splineloft::testing_curves
