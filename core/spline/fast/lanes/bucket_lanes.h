// The table in which a value finds the place that it has among many, compiled for every set of
// instructions.
#pragma once

#include <cstddef>
#include <cstdint>

namespace splineloft::lanes {

/// Equally wide buckets for values from `start` on.
struct Buckets {
    double start = 0, perUnit = 0;

    /// Never falls as the value rises, however it is rounded; so what is in a bucket is between all
    /// that is in earlier and in later ones.
    std::size_t of(double value) const {
        return static_cast<std::size_t>(static_cast<std::int64_t>((value - start) * perUnit));
    }
};

/// Of so many buckets beside each other, the entries are written at once.
inline constexpr std::size_t bucketsAhead = 4;

/// For values x[first] to x[last - 1], first > 0, which rise as those before them do: behind the
/// bucket of each, entries get its number, up to the next one's bucket, or `bucketsAhead` of them.
void fillBuckets(const Buckets& buckets, const double* x, std::size_t first, std::size_t last,
                 std::uint32_t* entries);

/// Whether one of these values is in the same bucket as x[i - distance], i its number; of which the
/// first `distance` do not count.
bool shareBucket(const Buckets& buckets, const double* x, std::size_t first, std::size_t last,
                 std::size_t distance);

} // namespace splineloft::lanes
