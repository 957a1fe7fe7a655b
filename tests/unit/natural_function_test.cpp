// The natural spline of a function: known values, its laws, and a solution in long double.
#include "core/spline/fast/natural_function.h"

#include "tests/unit/random_pieces.h"
#include "tests/unit/random_values.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <stdexcept>
#include <string>

namespace splineloft {
namespace {

using testing_curves::scattered;
using testing_curves::Values;

Values rising(std::size_t count, double least, double most, std::uint64_t seed) {
    std::mt19937_64 dice(seed);
    std::uniform_real_distribution<double> exponent(std::log(least), std::log(most));
    Values x = {0};
    while (x.size() < count) {
        const double next = x.back() + std::exp(exponent(dice));
        x.push_back(std::max(next, std::nextafter(x.back(), next + 1)));
    }
    return x;
}

Values scaled(Values values, double factor) {
    for (auto& value : values) {
        value *= factor;
    }
    return values;
}

/// What the constructor says against x and y.
std::string refusal(const Values& x, const Values& y) {
    try {
        const NaturalFunction function(x, y);
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "nothing";
}

/// The slopes of the natural spline, plainly, in long double.
std::vector<long double> preciseSlopes(const Values& x, const Values& y) {
    const std::size_t n = x.size();
    std::vector<long double> over(n), slope(n);
    const auto h = [&](std::size_t i) { return static_cast<long double>(x[i + 1]) - x[i]; };
    const auto s = [&](std::size_t i) {
        return (static_cast<long double>(y[i + 1]) - y[i]) / h(i);
    };
    over[0] = 0.5L;
    slope[0] = 1.5L * s(0);
    for (std::size_t i = 1; i < n; ++i) {
        const bool last = i == n - 1;
        const long double below = last ? 1 : h(i);
        const long double above = last ? 0 : h(i - 1);
        const long double diagonal = last ? 2 : 2 * (h(i - 1) + h(i));
        const long double right = last ? 3 * s(i - 1) : 3 * (h(i) * s(i - 1) + h(i - 1) * s(i));
        const long double pivot = diagonal - below * over[i - 1];
        over[i] = above / pivot;
        slope[i] = (right - below * slope[i - 1]) / pivot;
    }
    for (std::size_t i = n - 1; i-- > 0;) {
        slope[i] -= over[i] * slope[i + 1];
    }
    return slope;
}

TEST(NaturalFunction, ofThreePointsIsKnown) {
    // 0, 1, 0 at 0, 1, 2: M[1] = -3, so y = (3 x - x^3) / 2 on the first piece.
    const NaturalFunction tent(Values{0, 1, 2}, Values{0, 1, 0});
    EXPECT_DOUBLE_EQ(tent(0.5), 0.6875);
    EXPECT_DOUBLE_EQ(tent(1.5), 0.6875);
    EXPECT_DOUBLE_EQ(tent.secondAt(1), -3);
    EXPECT_DOUBLE_EQ(tent.derivative(0), 1.5);
    EXPECT_DOUBLE_EQ(tent.second(0.5), -1.5);
    EXPECT_DOUBLE_EQ(tent.integral(0, 2), 1.25);
    EXPECT_DOUBLE_EQ(tent.integral(2, 0), -1.25);
    EXPECT_DOUBLE_EQ(tent.integral(0.5, 1.5), 2 * (0.625 - (0.1875 - 1.0 / 128)));
    // Uneven: h = 1, 2 and slopes 1, -1/2 give M[1] = 6 (-3/2) / (2 * 3) = -3/2.
    const NaturalFunction uneven(Values{0, 1, 3}, Values{0, 1, 0});
    EXPECT_DOUBLE_EQ(uneven.secondAt(1), -1.5);
    EXPECT_DOUBLE_EQ(uneven(2), 0.5 + 1.5 * (1 + 1) * 0.25 * 0.5);
}

TEST(NaturalFunction, ofALineIsTheLine) {
    for (const std::size_t count : {2u, 3u, 50u, 5000u}) {
        const Values x = rising(count, 0.01, 10, count);
        Values y;
        for (const double at : x) {
            y.push_back(3 - 2 * at);
        }
        const NaturalFunction line(x, y);
        const double size = std::abs(y.back()) + 3;
        for (const double part : {-0.5, 0.0, 0.123, 0.5, 0.987, 1.0, 1.5}) {
            const double at = part * x.back();
            EXPECT_NEAR(line(at), 3 - 2 * at, 1e-13 * size) << count << " points, x = " << at;
            EXPECT_NEAR(line.derivative(at), -2, 1e-11) << count << " points, x = " << at;
        }
        EXPECT_NEAR(line.integral(x.front(), x.back()), x.back() * (3 - x.back()),
                    1e-12 * size * x.back());
    }
}

/// Of a whole period of the sine, whose second derivatives vanish at both ends.
TEST(NaturalFunction, approachesTheSine) {
    const double whole = 2 * std::numbers::pi;
    Values x, y;
    for (int i = 0; i <= 1000; ++i) {
        x.push_back(whole * i / 1000);
        y.push_back(std::sin(x.back()));
    }
    const NaturalFunction sine(x, y);
    for (double at = 0; at <= whole; at += 0.0137) {
        EXPECT_NEAR(sine(at), std::sin(at), 2e-11) << at; // 5 h^4 / 384
        EXPECT_NEAR(sine.derivative(at), std::cos(at), 2e-8) << at;
        EXPECT_NEAR(sine.second(at), -std::sin(at), 1e-5) << at;
        EXPECT_NEAR(sine.integral(0, at), 1 - std::cos(at), 1e-11) << at;
    }
}

TEST(NaturalFunction, isSmoothAtItsPointsAndFreeAtItsEnds) {
    const Values x = rising(40, 0.05, 5, 3);
    const Values y = scattered(40, 10, 4);
    const NaturalFunction function(x, y);
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double before = std::nextafter(x[i], -1e9);
        EXPECT_NEAR(function(x[i]), y[i], 1e-13 * 10) << i;
        EXPECT_NEAR(function(before), y[i], 1e-11) << i;
        EXPECT_NEAR(function.derivative(before), function.derivative(x[i]), 1e-9) << i;
        EXPECT_NEAR(function.second(before), function.secondAt(i), 1e-7) << i;
    }
    EXPECT_EQ(function.secondAt(0), 0);
    EXPECT_EQ(function.secondAt(39), 0);
    EXPECT_EQ(function.second(x.back() + 1), 0);
    const double slope = function.derivative(x.back());
    EXPECT_DOUBLE_EQ(function(x.back() + 2), y.back() + 2 * slope) << "straight on";
    EXPECT_DOUBLE_EQ(function.integral(x.back(), x.back() + 2), 2 * y.back() + 2 * slope);
    EXPECT_DOUBLE_EQ(function(-2), y[0] - 2 * function.derivative(0));
    EXPECT_DOUBLE_EQ(function.integral(-2, 0), 2 * y[0] - 2 * function.derivative(0));
}

/// The spline s bends least: adding any e that is 0 at the points adds the bending of e, since the
/// integral of s'' e'' is 0. So no multiple of e can lower it.
TEST(NaturalFunction, bendsLeastOfAll) {
    const Values x = {0, 1, 1.5, 4, 4.2, 7};
    const NaturalFunction function(x, Values{3, -1, 2, 2, 5, 0});
    std::mt19937_64 dice(8);
    std::uniform_real_distribution<double> roll(-1, 1);
    for (int trial = 0; trial < 20; ++trial) {
        double bending = 0, product = 0, added = 0;
        for (std::size_t i = 0; i + 1 < x.size(); ++i) {
            // e = t^2 (1-t)^2 (a + b t) of the piece has no slope at the points either.
            const double h = x[i + 1] - x[i];
            const double a = roll(dice), b = roll(dice);
            for (int k = 0; k < 1000; ++k) {
                const double t = (k + 0.5) / 1000;
                const double e =
                    (a * (2 - 12 * t + 12 * t * t) + b * (6 * t - 24 * t * t + 20 * t * t * t)) /
                    (h * h);
                const double s = function.second(x[i] + h * t);
                bending += s * s * h / 1000;
                product += s * e * h / 1000;
                added += e * e * h / 1000;
            }
        }
        EXPECT_LT(std::abs(product), 1e-5 * std::sqrt(bending * added)) << trial;
    }
}

/// Values at `places`, many at once and one by one, are those of a solution in long double.
void expectValues(const NaturalFunction& function, const Values& x, const Values& y,
                  const std::vector<long double>& slopes, const Values& places) {
    Values values(places.size());
    function.evaluate(places, values);
    for (std::size_t k = 0; k < places.size(); ++k) {
        const double at = places[k];
        EXPECT_EQ(values[k], function(at)) << "one by one, at " << at;
        if (at < 0) {
            continue;
        }
        const auto i = static_cast<std::size_t>(std::ranges::upper_bound(x, at) - x.begin()) - 1;
        const long double h = static_cast<long double>(x[i + 1]) - x[i];
        const long double u = (at - static_cast<long double>(x[i])) / h;
        const long double rise = static_cast<long double>(y[i + 1]) - y[i];
        const long double c = 3 * rise - h * (2 * slopes[i] + slopes[i + 1]);
        const long double d = h * (slopes[i] + slopes[i + 1]) - 2 * rise;
        const long double wanted = y[i] + u * (h * slopes[i] + u * (c + u * d));
        EXPECT_NEAR(values[k], static_cast<double>(wanted), 1e-13) << "at " << at;
    }
}

TEST(NaturalFunction, agreesWithALongDoubleSolveOnEveryInstructionSet) {
    for (const std::size_t count : {2u, 3u, 5u, 8u, 9u, 17u, 641u, 642u, 700u, 1000u, 8449u, 8450u,
                                    10'000u, 12'674u, 100'000u}) {
        const Values x = rising(count, 0.1, 1, count);
        const Values y = scattered(count, 1, count + 1);
        const auto slopes = preciseSlopes(x, y);
        const Values places = scaled(scattered(2000, 0.5, 7), x.back());
        test::onEveryInstructionSet([&](const std::string& instructions) {
            SCOPED_TRACE(instructions + ", " + std::to_string(count) + " points");
            expectValues(NaturalFunction(x, y), x, y, slopes, places);
        });
    }
}

/// A spike is felt, ever more weakly, farther away than the solver looks back and ahead where it
/// cuts the rows up; every slope is right to its last digits nevertheless.
TEST(NaturalFunction, feelsASpikeHoweverFarAwayItIs) {
    const std::size_t count = 13'000;
    const Values x = rising(count, 0.2, 1, 2);
    for (const std::size_t spike : {0u, 1u, 300u, 4224u, 4225u, 4600u, 8448u, 12'700u, 12'999u}) {
        Values y(count, 0);
        y[spike] = 1e70;
        const auto slopes = preciseSlopes(x, y);
        test::onEveryInstructionSet([&](const std::string& instructions) {
            const NaturalFunction function(x, y);
            for (std::size_t i = 0; i < count; ++i) {
                const auto wanted = static_cast<double>(slopes[i]);
                ASSERT_NEAR(function.derivative(x[i]), wanted, 1e-12 * std::abs(wanted) + 1e-280)
                    << instructions << ", spike at " << spike << ", slope at " << i;
            }
        });
    }
}

/// Rows forget what was before them the more slowly the more the intervals grow.
TEST(NaturalFunction, isExactOverIntervalsThatGrowAndShrink) {
    const std::size_t count = 9000;
    Values x = {0};
    for (std::size_t i = 1; i < count; ++i) {
        x.push_back(x.back() + std::exp2(static_cast<double>(i % 40)));
    }
    const Values y = scattered(count, 1, 3);
    const auto slopes = preciseSlopes(x, y);
    test::onEveryInstructionSet([&](const std::string& instructions) {
        const NaturalFunction function(x, y);
        for (std::size_t i = 1; i + 1 < count; ++i) {
            const auto wanted = static_cast<double>(slopes[i]);
            const double chord = std::abs(y[i + 1] - y[i]) / (x[i + 1] - x[i]);
            ASSERT_NEAR(function.derivative(x[i]), wanted, 1e-13 * (std::abs(wanted) + chord))
                << instructions << ", slope at " << i;
        }
    });
}

/// The table of places is written in one go: none of its entries may be left from other points.
TEST(NaturalFunction, findsTheRightPieceAfterOtherPoints) {
    const std::size_t count = 200;
    NaturalFunction function(scaled(rising(count, 1e-6, 1, 3), 5), scattered(count, 1, 4));
    for (const double power : {1.0, 3.0, 0.2, 20.0}) {
        Values x(count);
        for (std::size_t i = 0; i < count; ++i) {
            x[i] = std::pow(static_cast<double>(i) / static_cast<double>(count - 1), power) +
                   1e-9 * static_cast<double>(i);
        }
        const Values y = scattered(count, 1, 9);
        function.refit(x, y);
        for (std::size_t i = 0; i < count; ++i) {
            ASSERT_NEAR(function(x[i]), y[i], 1e-12) << "point " << i << ", power " << power;
        }
    }
}

TEST(NaturalFunction, findsTheRightPieceHoweverUnevenThePointsAre) {
    for (const double least : {1.0, 1e-3, 1e-12, 1e-100}) {
        const Values x = rising(3000, least, 1, 5);
        Values y = scattered(3000, 1, 6);
        const NaturalFunction function(x, y);
        Values values(x.size());
        function.evaluate(x, values);
        for (std::size_t i = 0; i < x.size(); ++i) {
            ASSERT_NEAR(values[i], y[i], 1e-12) << "x[" << i << "] of intervals above " << least;
        }
    }
}

TEST(NaturalFunction, staysFiniteAtEverySize) {
    const Values x = rising(1000, 0.1, 1, 1);
    const Values y = scattered(1000, 1, 2);
    const NaturalFunction plain(x, y);
    for (const double xSize : {1.0, 0x1p-1000, 0x1p-500, 0x1p500, 0x1p1010}) {
        for (const double ySize : {1.0, 0x1p-1000, 0x1p-500, 0x1p500, 0x1p1010}) {
            const NaturalFunction function(scaled(x, xSize), scaled(y, ySize));
            for (const double at : {-1.0, 0.0, 1.23, 100.0, 333.3, 600.0}) {
                EXPECT_EQ(function(at * xSize), plain(at) * ySize) << xSize << ", " << ySize;
            }
            EXPECT_TRUE(std::isfinite(function.integral(0, xSize)) || xSize * ySize > 1e300);
        }
    }
    constexpr double most = std::numeric_limits<double>::max();
    constexpr double least = std::numeric_limits<double>::denorm_min();
    const NaturalFunction widest(Values{-most, 0, most}, Values{-most, 0, most});
    EXPECT_NEAR(widest(most / 2) / most, 0.5, 1e-15);
    EXPECT_NEAR(widest.derivative(0), 1, 1e-15);
    const NaturalFunction narrowest(Values{0, least, 2 * least}, Values{0, least, 2 * least});
    EXPECT_EQ(narrowest(least), least);
    EXPECT_EQ(NaturalFunction(Values{0, 1}, Values{0, 0})(0.3), 0);
    EXPECT_TRUE(std::isnan(plain(std::nan(""))));
}

TEST(NaturalFunction, refusesWhatItCannotPassThrough) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    EXPECT_EQ(refusal({0, 1, 2, 2}, {0, 0, 0, 0}),
              "x[3] = 2 is not above x[2] = 2; right would be rising values");
    EXPECT_EQ(refusal({0, 1, 0.5}, {0, 0, 0}),
              "x[2] = 0.5 is not above x[1] = 1; right would be rising values");
    EXPECT_EQ(refusal({0, 1, infinity}, {0, 0, 0}),
              "x[2] = inf is not a finite number; right would be a finite one");
    EXPECT_EQ(refusal({0, 1, 2}, {0, -infinity, 0}),
              "y[1] = -inf is not a finite number; right would be a finite one");
    for (const double sign : {1.0, -1.0}) {
        const double nothing = std::copysign(std::nan(""), sign);
        EXPECT_NE(refusal({0, nothing, 2}, {0, 0, 0}).find("x[1] = "), std::string::npos);
        EXPECT_NE(refusal({0, 1, 2}, {0, 0, nothing}).find("y[2] = "), std::string::npos);
    }
    EXPECT_EQ(refusal({0, 1, 2}, {0, 1}),
              "there are 3 values of x and 2 of y; right would be as many of both");
    EXPECT_EQ(refusal({0}, {1}), "there are 1 points; right would be 2 to 4294967295");
    NaturalFunction function(Values{0, 1}, Values{2, 4});
    EXPECT_THROW(function.refit(Values{0, 0}, Values{1, 1}), std::invalid_argument);
    EXPECT_EQ(function(0.5), 3) << "unchanged";
    Values out(1);
    EXPECT_THROW(function.evaluate(Values{1, 2}, out), std::invalid_argument);
    function.refit(Values{0, 1, 2}, Values{1, 1, 1});
    EXPECT_EQ(function(1.5), 1);
    EXPECT_EQ(function.size(), 3u);
}

TEST(NaturalFunction, refusesIntervalsTooUnevenForADouble) {
    const std::vector y{1.0, 2.0, 3.0};
    for (const double nearest : {5e-324, 1e-300, 1e-101}) {
        const std::vector x{0.0, nearest, 1.0};
        EXPECT_THROW(NaturalFunction(x, y), std::invalid_argument) << nearest;
    }
    const NaturalFunction bearable(std::vector{0.0, 1e-90, 1.0}, y);
    EXPECT_TRUE(std::isfinite(bearable(0.5)));
}

} // namespace
} // namespace splineloft
