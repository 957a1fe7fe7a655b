// Which of equally wide buckets a value falls into.
#pragma once

#include <cstddef>
#include <cstdint>

namespace splineloft {

/// Buckets for values from `start` on, fewer than 2^32.
struct Buckets {
    double start = 0, perUnit = 0;

    /// Never falls as the value rises, however it is rounded; so what is in a bucket is between all
    /// that is in earlier and in later ones.
    std::size_t of(double value) const {
        return static_cast<std::size_t>(static_cast<std::int64_t>((value - start) * perUnit));
    }
};

} // namespace splineloft
