// Which of equally wide buckets values fall into, compiled for every set of instructions.
#pragma once

#include <cstddef>
#include <cstdint>

namespace splineloft::lanes {

/// Buckets for values from `start` on, fewer than 2^32.
struct Buckets {
    double start = 0, perUnit = 0;

    /// Never falls as the value rises, however it is rounded; so what is in a bucket is between all
    /// that is in earlier and in later ones.
    std::size_t of(double value) const {
        return static_cast<std::size_t>(static_cast<std::int64_t>((value - start) * perUnit));
    }
};

/// The buckets of rising values, as `of` says.
void findBuckets(const Buckets& buckets, const double* values, std::size_t count,
                 std::uint32_t* found);

} // namespace splineloft::lanes
