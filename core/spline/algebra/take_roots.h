// Square roots, several by one instruction.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace splineloft {

/// Takes the square root of each. Written out, because compilers keep errno and therefore take
/// roots one by one.
template <std::size_t count>
    requires(count % 2 == 0)
void takeRoots(std::array<double, count>& values) {
#if defined(__SSE2__)
    for (std::size_t i = 0; i < count; i += 2) {
        _mm_storeu_pd(&values[i], _mm_sqrt_pd(_mm_loadu_pd(&values[i])));
    }
#else
    for (auto& value : values) {
        value = std::sqrt(value);
    }
#endif
}

} // namespace splineloft
