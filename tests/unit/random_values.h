// Random numbers, many at once.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

namespace splineloft::testing_curves {

using Values = std::vector<double>;

/// So many numbers from -size to size.
inline Values scattered(std::size_t count, double size, std::uint64_t seed) {
    std::mt19937_64 dice(seed);
    std::uniform_real_distribution<double> roll(-size, size);
    Values values(count);
    std::ranges::generate(values, [&] { return roll(dice); });
    return values;
}

} // namespace splineloft::testing_curves
