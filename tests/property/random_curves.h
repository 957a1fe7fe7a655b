// Curves for testing laws: every family of the catalog, in every way of ending, with random
// parameters and points. All from a seed, so that a failure can be repeated from its message.
#pragma once

#include "core/spline/curve.h"
#include "tests/cases.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <iosfwd>
#include <random>
#include <string>
#include <vector>

namespace splineloft {

/// How failures show a point.
void PrintTo(const Point& point, std::ostream* stream);

} // namespace splineloft

namespace splineloft::testing_curves {

/// Random numbers that are the same on every system (the standard's distributions are not).
class Dice {
  public:
    explicit Dice(std::uint64_t seed) : engine_(seed) {}

    /// Evenly from [low, high).
    double between(double low, double high);
    /// A whole number, both bounds included.
    int whole(int low, int high);
    bool oneIn(int chances) { return whole(1, chances) == 1; }
    /// A multiple of 2^-20 below `extent` in size. Sums of few such numbers and whole numbers are
    /// exact, so that a moved curve differs by the curve's rounding only, not by its points'.
    double onGrid(double extent);
    /// A point of such numbers.
    Point pointOnGrid(int dimension, double extent);

  private:
    std::mt19937_64 engine_;
};

/// How many curves of each form most laws are tried on.
inline constexpr int usualRounds = 24;

/// A family with one way of ending.
struct CurveForm {
    std::string family;
    bool closed = false;
    Ends ends = Ends::none;
};

/// All forms of one family, open ones first.
std::vector<CurveForm> formsOf(const std::string& family);
/// All forms of all families.
std::vector<CurveForm> everyForm();

/// A curve without points, which has one coordinate name for each of `dimension`.
Curve emptyCurve(const CurveForm& form, int dimension);
/// Sets every parameter to a random value of its slider's range; now and then to an end of it.
void rollParameters(Curve& curve, Dice& dice);
/// Gives the curve `count` random points around `center`, and tangents where it wants them.
void rollPoints(Curve& curve, std::size_t count, const Point& center, double extent, Dice& dice);

/// A random curve with pieces, off the origin by up to 1000.
Curve randomCurve(const CurveForm& form, std::uint64_t seed);
/// The same curve drawn through other points.
Curve withPoints(Curve curve, const std::vector<Point>& points);

/// All that is needed to see which curve failed.
std::string wordsOf(const Curve& curve);

/// Largest absolute coordinate of points and tangents.
double farthest(const Curve& curve);
/// The most that the absolute weights of a Bézier point sum to: how much rounding can grow.
double amplification(const BlendPieces& blends);
/// Rounding to be expected in a Bézier point of this curve: each is a sum of up to `degree + 5`
/// terms, each rounded a few times, none larger than the farthest coordinate times the
/// amplification.
double roundingOf(const Curve& curve, const BlendPieces& blends);

/// Calls `law(curve)` with `rounds` random curves of every form of the family, fewer under the
/// sanitizers.
template <class Law> void forEveryForm(const std::string& family, int rounds, Law law) {
    for (const auto& form : formsOf(family)) {
        for (int round = 0; round < roundsOf(rounds); ++round) {
            const auto seed = static_cast<std::uint64_t>(round) * 7919 + 17;
            const Curve curve = randomCurve(form, seed);
            SCOPED_TRACE(wordsOf(curve) + " seed " + std::to_string(seed));
            law(curve);
            if (testing::Test::HasFatalFailure() || testing::Test::HasNonfatalFailure()) {
                return; // one example says it; hundreds would hide it
            }
        }
    }
}

/// A test for each family of the catalog.
class EveryFamily : public testing::TestWithParam<std::string> {};
std::vector<std::string> familyIds();
std::string testNameOf(const testing::TestParamInfo<std::string>& info);

/// EXPECT_NEAR for points.
void expectNear(const Point& ours, const Point& wanted, double tolerance, const std::string& what);

} // namespace splineloft::testing_curves
