#include "core/spline/measure/quadrature.h"

#include "core/spline/fast/lanes/chart_lanes.h"

namespace splineloft::gauss {
namespace {

/// What makes Legendre coefficients of sums of pairs (parity 0: even orders) or of differences
/// (parity 1: odd ones): column after column, one a pair.
constexpr lanes::EightByEight coefficientsOf(std::size_t parity) {
    lanes::EightByEight result{};
    for (std::size_t pair = 0; pair < pairs; ++pair) {
        double before = 0; // Bonnet's recursion for the Legendre polynomials
        double here = 1;
        for (std::size_t k = 0; k < count; ++k) {
            const auto order = static_cast<double>(k);
            if (k % 2 == parity) {
                result[pair][k / 2] = (2 * order + 1) / 2 * weights[pair] * here;
            }
            const double next =
                ((2 * order + 1) * nodes[pair] * here - order * before) / (order + 1);
            before = here;
            here = next;
        }
    }
    return result;
}

constexpr auto evenCoefficients = coefficientsOf(0);
constexpr auto oddCoefficients = coefficientsOf(1);

} // namespace

Spectrum::Spectrum(const Samples& samples) {
    lanes::weighPairs(evenCoefficients, oddCoefficients, samples, even_, odd_);
}

} // namespace splineloft::gauss
