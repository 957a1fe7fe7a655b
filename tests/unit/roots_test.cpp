#include "core/spline/algebra/roots.h"

#include "core/spline/algebra/bernstein.h"

#include "tests/property/random_curves.h"

#include <algorithm>
#include <cmath>

namespace splineloft {
namespace {

using testing_curves::Dice;

/// The polynomial with these zeros.
Bernstein withZeros(const std::vector<double>& zeros) {
    Bernstein result = {1};
    for (const double zero : zeros) {
        result = product(result, std::vector{-zero, 1 - zero});
    }
    return result;
}

TEST(Roots, ofRandomPolynomialsOfKnownZeros) {
    for (std::uint64_t seed = 0; seed < 5000; ++seed) {
        Dice dice(seed);
        std::vector<double> zeros;
        for (int i = dice.whole(1, 6); i > 0; --i) {
            zeros.push_back(dice.between(-0.5, 1.5));
        }
        std::ranges::sort(zeros);
        bool apart = true;
        for (std::size_t i = 0; i + 1 < zeros.size(); ++i) {
            apart = apart && zeros[i + 1] - zeros[i] > 0.02;
        }
        if (!apart) {
            continue;
        }
        std::vector<double> wanted;
        std::ranges::copy_if(zeros, std::back_inserter(wanted),
                             [](double u) { return u >= 0 && u <= 1; });
        const auto found = rootsOf(withZeros(zeros));
        ASSERT_EQ(found.size(), wanted.size()) << "seed " << seed;
        for (std::size_t i = 0; i < wanted.size(); ++i) {
            EXPECT_NEAR(found[i], wanted[i], 1e-8) << "seed " << seed;
        }
    }
}

TEST(Roots, doubleOnesAreFoundOnceAndExactly) {
    for (std::uint64_t seed = 0; seed < 2000; ++seed) {
        Dice dice(seed);
        const double twice = dice.between(0.01, 0.99);
        const double other = dice.between(1.2, 3);
        for (const auto& zeros : {std::vector{twice, twice}, std::vector{twice, twice, other},
                                  std::vector{twice, twice, other, -other}}) {
            const auto found = rootsOf(withZeros(zeros));
            ASSERT_EQ(found.size(), 1u) << "seed " << seed << " at " << twice;
            EXPECT_NEAR(found.front(), twice, 1e-13) << "seed " << seed;
        }
    }
}

TEST(Roots, highMultiplesAreOne) {
    for (const double zero : {0.0, 0.3, 0.5, 1.0}) {
        for (std::size_t times = 3; times <= 12; ++times) {
            const auto found = rootsOf(withZeros(std::vector(times, zero)));
            ASSERT_EQ(found.size(), 1u) << zero << " " << times << " times";
            EXPECT_NEAR(found.front(), zero, 1e-9) << times << " times";
        }
    }
}

TEST(Roots, closePairsAreTwo) {
    for (const double gap : {1e-1, 1e-3, 1e-5, 1e-7}) {
        const auto found = rootsOf(withZeros({0.37, 0.37 + gap, 1.4}));
        ASSERT_EQ(found.size(), 2u) << gap;
        EXPECT_NEAR(found[1] - found[0], gap, 1e-9 / gap * 1e-6 + 1e-12);
    }
}

TEST(Roots, ofHighDegreeEndAndDoNotRepeat) {
    Dice dice(3);
    for (const int degree : {20, 60, 200}) {
        std::vector<double> coefficients;
        for (int i = 0; i <= degree; ++i) {
            coefficients.push_back(dice.between(-1, 1));
        }
        const auto found = rootsOf(coefficients);
        EXPECT_LE(found.size(), static_cast<std::size_t>(degree));
        EXPECT_EQ(std::ranges::adjacent_find(found, std::greater_equal()), found.end());
        for (const double u : found) {
            EXPECT_NEAR(valueAt(coefficients, u), 0, 1e-12);
        }
    }
}

TEST(Roots, whatIsBelowRoundingIsZero) {
    EXPECT_TRUE(rootsOf(std::vector{1e-9, -1e-9, 1e-9}, 1e-8).empty()) << "the zero polynomial";
    EXPECT_EQ(rootsOf(std::vector{1.0, 0.0, 1e-9}, 1e-8), std::vector{1.0});
    EXPECT_EQ(rootsOf(std::vector{1e-9, 0.5, 1.0}, 1e-8), std::vector{0.0});
    EXPECT_TRUE(rootsOf(std::vector{1.0, std::nan(""), -1.0}).size() <= 2);
    EXPECT_TRUE(rootsOf(std::vector{1.0, -1.0}, std::nan("")).empty());
}

/// Found by a fuzzer: Newton's first step leads from one half to the flat end beside 1 exactly.
TEST(Roots, doNotHideBehindAFlatEnd) {
    std::vector<double> steps(20);
    steps[11] = -29.864435792103006;
    steps[12] = 29.864435792103006;
    steps[13] = -2.2e-296;
    const auto roots = rootsOf(steps);
    EXPECT_TRUE(std::ranges::any_of(roots, [](double u) { return std::abs(u - 0.6) < 1e-14; }));
}

} // namespace
} // namespace splineloft
