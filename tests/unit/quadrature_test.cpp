// The rules of Gauss against polynomials, which they integrate exactly, and what samples tell.
#include "core/spline/measure/quadrature.h"

#include "tests/unit/random_pieces.h"

#include <gtest/gtest.h>

#include <cmath>

namespace splineloft::gauss {
namespace {

/// The Legendre polynomial of an order.
double legendre(std::size_t order, double x) {
    double before = 0, here = 1;
    for (std::size_t k = 0; k < order; ++k) {
        const auto n = static_cast<double>(k);
        const double next = ((2 * n + 1) * x * here - n * before) / (n + 1);
        before = here;
        here = next;
    }
    return here;
}

template <class F> Samples samplesOf(F f) {
    Samples samples;
    for (std::size_t i = 0; i < pairs; ++i) {
        samples.after[i] = f(nodes[i]);
        samples.before[i] = f(-nodes[i]);
    }
    return samples;
}

TEST(Quadrature, isExactForEvenPowersUpToTwiceTheNodes) {
    for (std::size_t power = 0; power < 2 * count; power += 2) {
        const auto exponent = static_cast<double>(power);
        const auto samples = samplesOf([&](double x) { return std::pow(x, exponent); });
        EXPECT_NEAR(integralOf(samples), 2 / (exponent + 1), 1e-15) << power;
    }
    for (std::size_t power = 0; power < 64; power += 2) {
        const auto exponent = static_cast<double>(power);
        double sum = 0;
        for (std::size_t i = 0; i < wide.nodes.size(); ++i) {
            sum += 2 * wide.weights[i] * std::pow(wide.nodes[i], exponent);
        }
        EXPECT_NEAR(sum, 2 / (exponent + 1), 1e-15) << power << " by the wide rule";
    }
}

TEST(Quadrature, findsTheLegendrePolynomialsInTheirSamples) {
    test::onEveryInstructionSet([](const std::string& instructions) {
        for (std::size_t order = 0; order < count; ++order) {
            const Spectrum spectrum(samplesOf([&](double x) { return legendre(order, x); }));
            for (std::size_t k = 0; k < count; ++k) {
                const auto& coefficients = k % 2 == 0 ? spectrum.even() : spectrum.odd();
                EXPECT_NEAR(coefficients[k / 2], k == order ? 1 : 0, 1e-14)
                    << instructions << ": order " << k << " of polynomial " << order;
            }
        }
    });
}

} // namespace
} // namespace splineloft::gauss
