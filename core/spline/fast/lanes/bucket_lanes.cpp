#include "core/spline/fast/lanes/bucket_lanes.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/spline/fast/lanes/bucket_lanes.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h, which compiles what follows several times.
#include <hwy/highway.h>

#include <limits>

HWY_BEFORE_NAMESPACE();
namespace splineloft::lanes::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

void find(const Buckets& buckets, const double* values, std::size_t count,
          std::uint32_t* HWY_RESTRICT found) {
    const hn::ScalableTag<double> d;
    const hn::Rebind<std::int32_t, decltype(d)> numbers; // halves of those of all buckets fit
    const auto lanes = hn::Lanes(d);
    const auto start = hn::Set(d, buckets.start);
    const auto perUnit = hn::Set(d, buckets.perUnit);
    const bool fit =
        count > 0 && buckets.of(values[count - 1]) <= std::numeric_limits<std::int32_t>::max();
    std::size_t i = 0;
    for (; fit && i + lanes <= count; i += lanes) {
        const auto place = hn::Mul(hn::Sub(hn::LoadU(d, values + i), start), perUnit);
        const auto bucket = hn::DemoteTo(numbers, place);
        hn::StoreU(hn::BitCast(hn::RebindToUnsigned<decltype(numbers)>(), bucket),
                   hn::RebindToUnsigned<decltype(numbers)>(), found + i);
    }
    for (; i < count; ++i) {
        found[i] = static_cast<std::uint32_t>(buckets.of(values[i]));
    }
}

} // namespace
} // namespace splineloft::lanes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace splineloft::lanes {

HWY_EXPORT(find);

void findBuckets(const Buckets& buckets, const double* values, std::size_t count,
                 std::uint32_t* found) {
    HWY_DYNAMIC_DISPATCH(find)(buckets, values, count, found);
}

} // namespace splineloft::lanes
#endif
