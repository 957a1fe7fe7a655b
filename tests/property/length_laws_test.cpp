// Laws of arc length on random pieces: near cusps, of every kind of piece, and back from lengths to
// spots.
#include "tests/cases.h"
#include "tests/property/hard_pieces.h"
#include "tests/property/random_curves.h"

#include "core/spline/measure/length.h"
#include "core/spline/measure/sample.h"

#include <cmath>
#include <numeric>

namespace splineloft::testing_curves {
namespace {

/// Prints what a failure needs to be repeated, and what success is worth.
void printCases(const char* law, int cases, std::uint64_t seed) {
    std::printf("    %s: %d cases, seed %llu\n", law, cases, static_cast<unsigned long long>(seed));
}

using Real = long double;

/// Length from u = a to b by a rule of its own: Lobatto's with 5 points, halved until both halves
/// agree with the whole, and the Bézier polygon nowhere turns back: so no cusp hides between
/// samples.
class Measure {
  public:
    explicit Measure(const Piece& piece) : piece_(piece) {
        for (int i = 0; i <= piece.degree; ++i) {
            size_ += static_cast<Real>(norm(piece.bezierPoint(i) - piece.bezierPoint(0)) +
                                       norm(piece.bezierPoint(i)) / 64);
        }
    }
    Real between(Real a, Real b, Real tolerance) const {
        return refined(a, b, panel(a, b), tolerance * size_, 0);
    }

  private:
    Real speed(Real u) const {
        // de Casteljau on the hodograph of homogeneous points, in long double.
        const auto width = static_cast<std::size_t>(piece_.width());
        std::vector<Real> rungs(piece_.coordinates.begin(), piece_.coordinates.end());
        for (auto left = rungs.size(); left > 2 * width; left -= width) {
            for (std::size_t i = 0; i + width < left; ++i) {
                rungs[i] += u * (rungs[i + width] - rungs[i]);
            }
        }
        const bool rational = piece_.form == splineloft::Form::rational;
        const Real from = rational ? rungs[width - 1] : 1;
        const Real to = rational ? rungs[2 * width - 1] : 1;
        const Real weight = from + u * (to - from);
        Real sum = 0;
        for (std::size_t c = 0; c < static_cast<std::size_t>(piece_.dimension); ++c) {
            const Real step = rungs[width + c] * from - rungs[c] * to;
            sum += step * step;
        }
        return piece_.degree * std::sqrt(sum) / (weight * weight);
    }
    Real panel(Real a, Real b) const {
        constexpr Real x = 0.6546536707079771437983L; // sqrt(3 / 7)
        const Real m = (a + b) / 2, h = (b - a) / 2;
        return h * (32 * speed(m) / 45 + 49 * (speed(m - h * x) + speed(m + h * x)) / 90 +
                    (speed(a) + speed(b)) / 10);
    }
    /// Whether all legs of the polygon from a to b point along its chord, or it is next to nothing.
    bool isStretched(Real a, Real b, Real tolerance) const {
        const auto width = static_cast<std::size_t>(piece_.width());
        const auto climb = [&](std::vector<Real>& rungs, std::size_t left, Real u) {
            for (std::size_t i = 0; i + width < left; ++i) {
                rungs[i] += u * (rungs[i + width] - rungs[i]);
            }
        };
        std::vector<Real> rungs(piece_.coordinates.begin(), piece_.coordinates.end());
        std::vector<Real> part;
        for (auto left = rungs.size(); left > 0; left -= width) {
            part.insert(part.end(), rungs.begin(), rungs.begin() + piece_.width());
            climb(rungs, left, b);
        }
        for (auto left = part.size(); left > width; left -= width) {
            climb(part, left, a / b);
        }
        const auto way = [&](std::size_t i, std::size_t j) {
            const bool rational = piece_.form == splineloft::Form::rational;
            std::vector<Real> result;
            for (std::size_t c = 0; c < static_cast<std::size_t>(piece_.dimension); ++c) {
                const Real from = part[i * width + c] / (rational ? part[(i + 1) * width - 1] : 1);
                const Real to = part[j * width + c] / (rational ? part[(j + 1) * width - 1] : 1);
                result.push_back(to - from);
            }
            return result;
        };
        const auto times = [](const std::vector<Real>& one, const std::vector<Real>& other) {
            return std::inner_product(one.begin(), one.end(), other.begin(), Real{0});
        };
        const auto degree = static_cast<std::size_t>(piece_.degree);
        const auto chord = way(0, degree);
        Real polygon = 0;
        bool isStretched = true;
        for (std::size_t i = 0; i < degree; ++i) {
            const auto leg = way(i, i + 1);
            const Real length = std::sqrt(times(leg, leg));
            polygon += length;
            isStretched =
                isStretched && times(leg, chord) >= 0.2L * length * std::sqrt(times(chord, chord));
        }
        return isStretched || polygon <= tolerance;
    }
    Real refined(Real a, Real b, Real whole, Real tolerance, int depth) const {
        const Real m = (a + b) / 2;
        const Real left = panel(a, m), right = panel(m, b);
        const bool agrees = std::abs(left + right - whole) <= tolerance;
        // (Rounding may turn any polygon that is short enough.)
        if (depth == 60 || --budget_ < 0 || (agrees && isStretched(a, b, tolerance))) {
            return left + right;
        }
        return refined(a, m, left, tolerance, depth + 1) +
               refined(m, b, right, tolerance, depth + 1);
    }

    Piece piece_;
    Real size_ = 0;
    mutable int budget_ = 20000; // panels
};

/// What errors are compared with: the length of the Bézier polygon, and the rounding of the points.
double polygonOf(const Piece& piece) {
    double sum = norm(piece.bezierPoint(0)) / 64;
    for (int k = 0; k < piece.degree; ++k) {
        sum += distance(piece.bezierPoint(k), piece.bezierPoint(k + 1));
    }
    return sum;
}

TEST(LengthOfRandomPieces, isRightToTheToleranceAskedFor) {
    constexpr std::uint64_t seed = 4711;
    Dice dice(seed);
    constexpr int cases = casesOf(20'000);
    for (int i = 0; i < cases; ++i) {
        const Pieces one = randomPiece(dice);
        SCOPED_TRACE("seed " + std::to_string(seed) + " case " + std::to_string(i) + ": " +
                     wordsOf(one));
        const double polygon = polygonOf(one[0]);
        const auto wanted = static_cast<double>(Measure(one[0]).between(0, 1, 1e-15L));
        for (const double relative : {1e-3, 1e-6, 1e-9}) {
            ASSERT_NEAR(lengthOf(one, relative * polygon), wanted, relative * polygon);
        }
        ASSERT_NEAR(lengthOf(one), wanted, 4e-14 * polygon);
        ASSERT_NEAR(ArcLength(one).total(), wanted, 4e-14 * polygon);
    }
    printCases("lengths", cases, seed);
}

TEST(LengthOfRandomPieces, ofPlaneCubicsNeverMisses) {
    constexpr std::uint64_t seed = 31;
    Dice dice(seed);
    constexpr int cases = casesOf(100'000);
    for (int i = 0; i < cases; ++i) {
        const Pieces one = nearlyCuspedCubic(dice, 2);
        const double polygon = polygonOf(one[0]);
        const double wanted = ArcLength(one).total();
        // Whether cut at one place or not, it is the same length.
        const double u = dice.between(0.01, 0.99);
        const auto halves = splitAt(one[0], u);
        SCOPED_TRACE("seed " + std::to_string(seed) + " case " + std::to_string(i) + ": " +
                     wordsOf(one));
        ASSERT_NEAR(ArcLength(halves).total(), wanted, 4e-14 * polygon);
        ASSERT_NEAR(lengthOf(one, 1e-9 * polygon), wanted, 1e-9 * polygon);
    }
    printCases("cuspy plane cubics", cases, seed);
}

/// What is quick on plane cubics agrees with what serves all pieces: the same curve in four
/// dimensions, of which two are empty, and as a rational piece.
TEST(LengthOfRandomPieces, isTheSameOnEveryPath) {
    constexpr std::uint64_t seed = 99;
    Dice dice(seed);
    constexpr int cases = casesOf(20'000);
    for (int i = 0; i < cases; ++i) {
        const int dimension = dice.whole(1, 3);
        const Pieces one = i % 2 == 0 ? nearlyCuspedCubic(dice, dimension)
                                      : randomPolynomial(dice, dice.whole(1, 3), dimension);
        SCOPED_TRACE("seed " + std::to_string(seed) + " case " + std::to_string(i) + ": " +
                     wordsOf(one));
        const double polygon = polygonOf(one[0]);
        const ArcLength lengths(one);
        const Pieces wide = inFourDimensions(one);
        const Pieces weighted = withWeightsOfOne(one);
        ASSERT_NEAR(ArcLength(wide).total(), lengths.total(), 4e-14 * polygon);
        ASSERT_NEAR(ArcLength(weighted).total(), lengths.total(), 4e-14 * polygon);
        const double length = dice.between(0, 1) * lengths.total();
        const Spot spot = lengths.spotAt(length);
        ASSERT_NEAR(lengths.upTo(spot), length, 4e-14 * polygon);
        ASSERT_NEAR(ArcLength(wide).upTo(spot), length, 4e-14 * polygon);
    }
    printCases("paths", cases, seed);
}

TEST(EvenSpacing, isEvenToOnePartInABillion) {
    constexpr std::uint64_t seed = 5;
    Dice dice(seed);
    constexpr int cases = casesOf(100'000);
    for (int i = 0; i < cases; ++i) {
        const Pieces curve = randomRow(dice, dice.whole(1, 4));
        SCOPED_TRACE("seed " + std::to_string(seed) + " case " + std::to_string(i) + ": " +
                     wordsOf(curve));
        const ArcLength lengths(curve);
        const auto count = static_cast<std::size_t>(dice.whole(2, dice.oneIn(4) ? 120 : 12));
        const auto spots = spread(curve, lengths, Even::length, count);
        ASSERT_EQ(spots.size(), count);
        ASSERT_EQ(spots.front(), Spot{});
        ASSERT_EQ(spots.back(), (Spot{curve.size() - 1, 1}));
        const double step = lengths.total() / static_cast<double>(count - 1);
        for (std::size_t k = 1; k < count; ++k) {
            const auto [s, u] = spots[k];
            const auto before = spots[k - 1];
            ASSERT_TRUE(before.segment < s || (before.segment == s && before.u <= u)) << k;
            ASSERT_NEAR(lengths.upTo(spots[k]) - lengths.upTo(before), step,
                        1e-9 * step + 4e-15 * lengths.total())
                << "step " << k;
        }
        // Against the other rule, at one step of each curve.
        const auto k = static_cast<std::size_t>(dice.whole(1, static_cast<int>(count) - 1));
        Real between = 0;
        for (auto s = spots[k - 1].segment; s <= spots[k].segment; ++s) {
            between += Measure(curve[s]).between(s == spots[k - 1].segment ? spots[k - 1].u : 0,
                                                 s == spots[k].segment ? spots[k].u : 1, 1e-14L);
        }
        ASSERT_NEAR(static_cast<double>(between), step, 1e-9 * step + 4e-14 * lengths.total());
    }
    printCases("even spacings", cases, seed);
}

TEST(EvenSpacing, hasTheSameSpotsManyOrOneByOne) {
    constexpr std::uint64_t seed = 6;
    Dice dice(seed);
    constexpr int cases = casesOf(1000);
    for (int i = 0; i < cases; ++i) {
        const Pieces curve = randomRow(dice, dice.whole(1, 3));
        SCOPED_TRACE("seed " + std::to_string(seed) + " case " + std::to_string(i) + ": " +
                     wordsOf(curve));
        const ArcLength lengths(curve);
        std::vector<double> asked;
        for (int k = dice.whole(0, 200); k > 0; --k) {
            asked.push_back(dice.between(-0.1, 1.1) * lengths.total());
        }
        std::ranges::sort(asked);
        const auto spots = lengths.spotsAt(asked);
        ASSERT_EQ(spots.size(), asked.size());
        for (std::size_t k = 0; k < asked.size(); ++k) {
            const Spot single = lengths.spotAt(asked[k]);
            ASSERT_NEAR(lengths.upTo(spots[k]), lengths.upTo(single), 4e-14 * lengths.total()) << k;
        }
    }
    printCases("many spots", cases, seed);
}

} // namespace
} // namespace splineloft::testing_curves
