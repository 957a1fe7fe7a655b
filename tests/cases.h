// How often something is tried. Under the sanitizers each try takes ten to twenty times as long,
// and the question is another one.
#pragma once

namespace splineloft::testing_curves {

#ifdef __SANITIZE_ADDRESS__
inline constexpr bool underSanitizers = true;
#else
inline constexpr bool underSanitizers = false;
#endif

/// So many random cases; a fortieth of them under the sanitizers.
constexpr int casesOf(int many) {
    return underSanitizers ? many / 40 : many;
}

/// So many rounds over something that is different each time; a quarter under the sanitizers.
constexpr int roundsOf(int some) {
    return underSanitizers ? (some + 3) / 4 : some;
}

} // namespace splineloft::testing_curves
