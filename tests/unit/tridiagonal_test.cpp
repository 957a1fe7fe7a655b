// The fast solver of tridiagonal equations against the plain one.
#include "core/spline/families/tridiagonal.h"

#include "tests/unit/random_values.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <span>

namespace splineloft {
namespace {

using families::Rows;
using testing_curves::scattered;
using testing_curves::Values;

/// Rows as natural splines have them, with intervals from `least` to 1.
void expectTheSameSolution(std::size_t count, double least, double size) {
    std::mt19937_64 dice(count);
    std::uniform_real_distribution<double> exponent(std::log(least), 0);
    Values intervals(count + 1), diagonal(count);
    std::ranges::generate(intervals, [&] { return size * std::exp(exponent(dice)); });
    for (std::size_t i = 0; i < count; ++i) {
        diagonal[i] = 2 * (intervals[i] + intervals[i + 1]);
    }
    Values right = scattered(count, size, count + 9);
    if (count > 100) { // a spike that is felt, and nothing else, a long way from it
        std::fill(right.begin() + static_cast<std::ptrdiff_t>(count / 3), right.end(), 0.0);
        right[count / 2] = 1e30 * size;
    }
    for (const bool swapped : {false, true}) { // equations of second derivatives, of slopes
        const auto low = std::span<const double>(intervals).subspan(swapped ? 1 : 0, count);
        const auto high = std::span<const double>(intervals).subspan(swapped ? 0 : 1, count);
        const Rows<double> rows{low, diagonal, high, right};
        EXPECT_EQ(families::solveTridiagonal(rows), families::solveRowByRow(rows))
            << count << " rows, intervals from " << least << " to 1 times " << size;
    }
}

TEST(Tridiagonal, inChainsIsTheSameToTheLastBitAsRowByRow) {
    for (const std::size_t count : {1u, 2u, 3u, 63u, 575u, 576u, 577u, 767u, 768u, 1000u, 2047u,
                                    2048u, 2049u, 2113u, 4096u, 5000u, 10'000u}) {
        for (const double least : {1.0, 0.1, 1e-6, 1e-100, 1e-300}) {
            expectTheSameSolution(count, least, 1);
        }
        expectTheSameSolution(count, 0.1, 1e-200);
        expectTheSameSolution(count, 0.1, 1e200);
    }
    expectTheSameSolution(1'000'000, 0.1, 1);
}

/// Rows that never forget: nothing is lost but time.
TEST(Tridiagonal, inChainsNeedsNoDominantDiagonal) {
    const std::size_t count = 10'000;
    const Values beside(count, -1), right = scattered(count, 1, 1);
    Values diagonal(count, 2);
    const Rows<double> rows{beside, diagonal, beside, right};
    EXPECT_EQ(families::solveTridiagonal(rows), families::solveRowByRow(rows));
}

} // namespace
} // namespace splineloft
