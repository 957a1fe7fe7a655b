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

// What follows compilers turn into vectors by themselves.

bool haveGaps(const std::uint32_t* buckets, std::size_t count) {
    std::uint32_t wide = 0;
    for (std::size_t k = 0; k < count; ++k) {
        wide |= buckets[k] - (buckets - 1)[k] > bucketsAhead ? 1 : 0;
    }
    return wide != 0;
}

bool anyRepeats(const std::uint32_t* buckets, std::size_t count, std::size_t distance) {
    const std::uint32_t* const before = buckets - distance;
    std::uint32_t same = 0;
    for (std::size_t k = 0; k < count; ++k) {
        same |= buckets[k] == before[k] ? 1 : 0;
    }
    return same != 0;
}

HWY_INLINE void writeAhead(std::uint32_t* behind, std::uint32_t number) {
    for (std::size_t k = 0; k < bucketsAhead; ++k) {
        behind[k] = number;
    }
}

void enter(const std::uint32_t* HWY_RESTRICT buckets, std::size_t count, std::uint32_t first,
           std::uint32_t* HWY_RESTRICT entries) {
    if (!haveGaps(buckets, count)) {
        for (std::size_t k = 0; k < count; ++k) {
            writeAhead(entries + buckets[k] + 1, first + static_cast<std::uint32_t>(k));
        }
        return;
    }
    std::size_t reached = *(buckets - 1) + bucketsAhead;
    for (std::size_t k = 0; k < count; ++k) {
        const auto number = first + static_cast<std::uint32_t>(k);
        for (; reached < buckets[k]; ++reached) {
            entries[reached + 1] = number - 1;
        }
        writeAhead(entries + buckets[k] + 1, number);
        reached = buckets[k] + bucketsAhead;
    }
}

} // namespace
} // namespace splineloft::lanes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace splineloft::lanes {

HWY_EXPORT(anyRepeats);
HWY_EXPORT(enter);
HWY_EXPORT(find);

void findBuckets(const Buckets& buckets, const double* values, std::size_t count,
                 std::uint32_t* found) {
    HWY_DYNAMIC_DISPATCH(find)(buckets, values, count, found);
}

void enterBuckets(const std::uint32_t* buckets, std::size_t count, std::uint32_t first,
                  std::uint32_t* entries) {
    HWY_DYNAMIC_DISPATCH(enter)(buckets, count, first, entries);
}

bool repeats(const std::uint32_t* buckets, std::size_t count, std::size_t distance) {
    return HWY_DYNAMIC_DISPATCH(anyRepeats)(buckets, count, distance);
}

} // namespace splineloft::lanes
#endif
