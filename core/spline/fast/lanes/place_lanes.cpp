#include "core/spline/fast/lanes/place_lanes.h"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/spline/fast/lanes/place_lanes.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h, which compiles what follows several times.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace splineloft::lanes::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using UpToEight = hn::CappedTag<double, 8>;
using Vector = hn::Vec<UpToEight>;

/// From the nearer end.
HWY_INLINE Vector coordinateAt(const CubicFromEnds& cubic, Vector u) {
    const UpToEight d;
    const auto fromEnd = hn::Sub(hn::Set(d, 1.0), u);
    const auto isEarly = hn::Le(u, fromEnd);
    const auto v = hn::Min(u, fromEnd);
    const auto power = [&](std::size_t i) HWY_ATTR {
        return hn::IfThenElse(isEarly, hn::Set(d, cubic.rise[i]), hn::Set(d, cubic.fall[i]));
    };
    return hn::MulAdd(v, hn::MulAdd(v, hn::MulAdd(v, power(3), power(2)), power(1)), power(0));
}

template <std::size_t dimension>
HWY_INLINE void placeVector(const std::array<CubicFromEnds, 3>& cubic, Vector u, double* places) {
    const UpToEight d;
    const auto x = coordinateAt(cubic[0], u), y = coordinateAt(cubic[1], u);
    if constexpr (dimension == 2) {
        hn::StoreInterleaved2(x, y, d, places);
    } else {
        hn::StoreInterleaved3(x, y, coordinateAt(cubic[2], u), d, places);
    }
}

template <std::size_t dimension>
HWY_INLINE void placeIn(const std::array<CubicFromEnds, 3>& cubic, const double* u,
                        std::size_t count, double* places) {
    const UpToEight d;
    const auto lanes = hn::Lanes(d);
    std::size_t i = 0;
    for (; i + lanes <= count; i += lanes) {
        placeVector<dimension>(cubic, hn::LoadU(d, u + i), places + i * dimension);
    }
    if (i < count) {
        std::array<double, 8> rest{};
        std::array<double, 8 * dimension> placesOfRest;
        std::copy(u + i, u + count, rest.begin());
        placeVector<dimension>(cubic, hn::LoadU(d, rest.data()), placesOfRest.data());
        std::copy_n(placesOfRest.begin(), (count - i) * dimension, places + i * dimension);
    }
}

void place(const std::array<CubicFromEnds, 3>& cubic, std::size_t dimension, const double* u,
           std::size_t count, double* places) {
    return dimension == 2 ? placeIn<2>(cubic, u, count, places)
                          : placeIn<3>(cubic, u, count, places);
}

} // namespace
} // namespace splineloft::lanes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace splineloft::lanes {

HWY_EXPORT(place);

void placeOnCubic(const std::array<CubicFromEnds, 3>& cubic, std::size_t dimension, const double* u,
                  std::size_t count, double* places) {
    HWY_DYNAMIC_DISPATCH(place)(cubic, dimension, u, count, places);
}

} // namespace splineloft::lanes
#endif
