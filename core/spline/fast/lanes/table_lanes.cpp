#include "core/spline/fast/lanes/table_lanes.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/spline/fast/lanes/table_lanes.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h, which compiles what follows several times.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace splineloft::lanes::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using Doubles = hn::ScalableTag<double>;
using Vector = hn::Vec<Doubles>;

/// A power of at least 1, by squaring.
HWY_INLINE Vector raised(Vector base, int power) {
    auto result = base;
    for (int left = power - 1; left > 0; left /= 2) {
        if (left % 2 == 1) {
            result = hn::Mul(result, base);
        }
        base = hn::Mul(base, base);
    }
    return result;
}

void ratios(const RatioTable& table, double* x, double* scale) {
    const Doubles d;
    const auto steps = hn::Set(d, table.steps);
    const auto direction = hn::Set(d, table.direction);
    for (std::size_t i = 0; i < table.count; i += hn::Lanes(d)) {
        const auto number = hn::Iota(d, static_cast<double>(i));
        const auto k = hn::MulAdd(direction, number, hn::Set(d, table.first));
        const auto rest = hn::Sub(steps, k);
        hn::StoreU(hn::Div(k, rest), d, x + i);
        hn::StoreU(raised(hn::Div(rest, steps), table.degree), d, scale + i);
    }
}

void nearerEnd(int degree, std::size_t count, double* u, double* scale, double* fromEnd) {
    const Doubles d;
    const auto one = hn::Set(d, 1.0);
    for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
        const auto along = hn::LoadU(d, u + i);
        const auto rest = hn::Sub(one, along);
        const auto far = hn::Lt(rest, along);
        const auto most = hn::Max(along, rest);
        hn::StoreU(hn::Div(hn::Min(along, rest), most), d, u + i);
        hn::StoreU(raised(most, degree), d, scale + i);
        hn::StoreU(hn::IfThenElseZero(far, one), d, fromEnd + i);
    }
}

} // namespace
} // namespace splineloft::lanes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace splineloft::lanes {

HWY_EXPORT(ratios);
HWY_EXPORT(nearerEnd);

void fillRatios(const RatioTable& table, double* x, double* scales) {
    HWY_DYNAMIC_DISPATCH(ratios)(table, x, scales);
}

void seeFromNearerEnd(int degree, std::size_t count, double* u, double* scales, double* fromEnd) {
    HWY_DYNAMIC_DISPATCH(nearerEnd)(degree, count, u, scales, fromEnd);
}

} // namespace splineloft::lanes
#endif
