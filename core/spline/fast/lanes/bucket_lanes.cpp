#include "core/spline/fast/lanes/bucket_lanes.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/spline/fast/lanes/bucket_lanes.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h, which compiles what follows several times.
#include <hwy/highway.h>

#include <algorithm>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace splineloft::lanes::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using Doubles = hn::CappedTag<double, 8>;
using Numbers = hn::Rebind<std::int32_t, Doubles>;

/// Whether the numbers of all buckets that are asked for fit those of a vector.
bool fit(const Buckets& buckets, const double* x, std::size_t last) {
    return buckets.of(x[last - 1]) <= std::numeric_limits<std::int32_t>::max();
}

HWY_INLINE hn::Vec<Numbers> bucketsOf(const Buckets& buckets, const double* x) {
    const Doubles d;
    const auto along = hn::Sub(hn::LoadU(d, x), hn::Set(d, buckets.start));
    return hn::DemoteTo(Numbers(), hn::Mul(along, hn::Set(d, buckets.perUnit)));
}

HWY_INLINE void writeAhead(std::uint32_t* entries, std::size_t bucket, std::size_t i) {
    std::fill_n(entries + bucket + 1, bucketsAhead, static_cast<std::uint32_t>(i));
}

void fillOne(const Buckets& buckets, const double* x, std::size_t i, std::uint32_t* entries) {
    const auto before = buckets.of(x[i - 1]);
    const auto bucket = buckets.of(x[i]);
    if (bucket > before + bucketsAhead) {
        std::fill(entries + before + bucketsAhead + 1, entries + bucket + 1,
                  static_cast<std::uint32_t>(i - 1));
    }
    writeAhead(entries, bucket, i);
}

void fill(const Buckets& buckets, const double* x, std::size_t first, std::size_t last,
          std::uint32_t* HWY_RESTRICT entries) {
    const Numbers numbers;
    const auto lanes = hn::Lanes(numbers);
    const auto ahead = hn::Set(numbers, static_cast<std::int32_t>(bucketsAhead));
    std::size_t i = first;
    const bool inLanes = fit(buckets, x, last);
    for (; inLanes && i + lanes <= last; i += lanes) {
        const auto own = bucketsOf(buckets, x + i);
        const auto before = bucketsOf(buckets, x + i - 1);
        if (hn::AllFalse(numbers, hn::Gt(hn::Sub(own, before), ahead))) {
            std::int32_t all[8];
            hn::StoreU(own, numbers, all);
            for (std::size_t k = 0; k < lanes; ++k) {
                writeAhead(entries, static_cast<std::size_t>(all[k]), i + k);
            }
        } else {
            for (std::size_t k = 0; k < lanes; ++k) {
                fillOne(buckets, x, i + k, entries);
            }
        }
    }
    for (; i < last; ++i) {
        fillOne(buckets, x, i, entries);
    }
}

bool share(const Buckets& buckets, const double* x, std::size_t first, std::size_t last,
           std::size_t distance) {
    const Numbers numbers;
    const auto lanes = hn::Lanes(numbers);
    std::size_t i = std::max(first, distance);
    const bool inLanes = fit(buckets, x, last);
    for (; inLanes && i + lanes <= last; i += lanes) {
        const auto same = hn::Eq(bucketsOf(buckets, x + i), bucketsOf(buckets, x + i - distance));
        if (!hn::AllFalse(numbers, same)) {
            return true;
        }
    }
    for (; i < last; ++i) {
        if (buckets.of(x[i]) == buckets.of(x[i - distance])) {
            return true;
        }
    }
    return false;
}

} // namespace
} // namespace splineloft::lanes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace splineloft::lanes {

HWY_EXPORT(fill);
HWY_EXPORT(share);

void fillBuckets(const Buckets& buckets, const double* x, std::size_t first, std::size_t last,
                 std::uint32_t* entries) {
    HWY_DYNAMIC_DISPATCH(fill)(buckets, x, first, last, entries);
}

bool shareBucket(const Buckets& buckets, const double* x, std::size_t first, std::size_t last,
                 std::size_t distance) {
    return HWY_DYNAMIC_DISPATCH(share)(buckets, x, first, last, distance);
}

} // namespace splineloft::lanes
#endif
