// How often a law is tried.
#pragma once

namespace splineloft::testing_curves {

/// So many random cases; a twentieth of them under the sanitizers, where each takes that much
/// longer and the question is another one.
constexpr int casesOf(int many) {
#ifdef __SANITIZE_ADDRESS__
    return many / 20;
#else
    return many;
#endif
}

} // namespace splineloft::testing_curves
