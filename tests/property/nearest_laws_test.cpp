// The nearest spot against trying very many, on pieces of every kind; and the index against no
// index.
#include "tests/cases.h"
#include "tests/property/hard_pieces.h"
#include "tests/property/random_curves.h"

#include "core/spline/measure/nearest.h"

#include <cmath>

namespace splineloft::testing_curves {
namespace {

/// The least distance that many even steps and golden sections around the best of them find.
double bruteForce(const Pieces& pieces, const Point& place, int steps) {
    double best = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const auto at = [&](double u) { return distance(pieces.position({i, u}), place); };
        double bestU = 0;
        double least = std::numeric_limits<double>::infinity();
        for (int k = 0; k <= steps; ++k) {
            const double u = static_cast<double>(k) / steps;
            if (const double here = at(u); here < least) {
                least = here;
                bestU = u;
            }
        }
        double low = std::max(bestU - 1.0 / steps, 0.0);
        double high = std::min(bestU + 1.0 / steps, 1.0);
        for (int k = 0; k < 40; ++k) {
            const double a = low + 0.382 * (high - low);
            const double b = low + 0.618 * (high - low);
            const double atA = at(a);
            const double atB = at(b);
            least = std::min({least, atA, atB});
            (atA < atB ? high : low) = atA < atB ? b : a;
        }
        best = std::min(best, least);
    }
    return best;
}

double farthestOf(const Pieces& pieces) {
    double farthest = 0;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        for (int k = 0; k <= pieces.degree(); ++k) {
            farthest = std::max(farthest, norm(pieces[i].bezierPoint(k)));
        }
    }
    return farthest;
}

/// Near the piece, on it, on a Bézier point, or far off.
Point randomPlace(Dice& dice, const Pieces& pieces) {
    const int dimension = pieces.dimension();
    const auto segment =
        static_cast<std::size_t>(dice.whole(0, static_cast<int>(pieces.size()) - 1));
    const Point on = pieces.position({segment, dice.between(0, 1)});
    switch (dice.whole(0, 6)) {
    case 0: return on;
    case 1: return pieces[segment].bezierPoint(dice.whole(0, pieces.degree()));
    case 2: return on + dice.pointOnGrid(dimension, 1e-3);
    case 3: return on + dice.pointOnGrid(dimension, 100);
    default: return on + dice.pointOnGrid(dimension, 3);
    }
}

void expectNearest(const Pieces& pieces, const Point& place, int steps) {
    const auto nearest = nearestTo(pieces, place);
    ASSERT_TRUE(nearest);
    ASSERT_EQ(nearest->distance, distance(pieces.position(nearest->spot), place));
    const double rounding =
        4e-15 * pieces.degree() * (farthestOf(pieces) + norm(place)) + 1e-13 * nearest->distance;
    ASSERT_LE(nearest->distance, bruteForce(pieces, place, steps) + rounding)
        << "at " << testing::PrintToString(place) << ", found segment " << nearest->spot.segment
        << " u " << nearest->spot.u;
    const auto indexed = NearestIndex(pieces).nearest(place);
    ASSERT_TRUE(indexed);
    ASSERT_NEAR(indexed->distance, nearest->distance, rounding);
}

TEST(NearestOfRandomPieces, isNotFartherThanBruteForceFinds) {
    constexpr std::uint64_t seed = 2024;
    Dice dice(seed);
    constexpr int pieces = casesOf(20'000), places = 5;
    for (int i = 0; i < pieces; ++i) {
        const Pieces one = randomPiece(dice);
        SCOPED_TRACE("seed " + std::to_string(seed) + " piece " + std::to_string(i) + ": " +
                     wordsOf(one));
        for (int k = 0; k < places; ++k) {
            ASSERT_NO_FATAL_FAILURE(expectNearest(one, randomPlace(dice, one), 100));
        }
    }
    std::printf("    nearest: %d cases, seed %llu\n", pieces * places,
                static_cast<unsigned long long>(seed));
}

/// The quick searches against the one for all pieces: the same curve in four dimensions.
TEST(NearestOfRandomPieces, isTheSameOnEveryPath) {
    constexpr std::uint64_t seed = 77;
    Dice dice(seed);
    constexpr int pieces = casesOf(10'000), places = 10;
    for (int i = 0; i < pieces; ++i) {
        const int dimension = dice.whole(1, 3);
        const Pieces one = dice.oneIn(2) ? nearlyCuspedCubic(dice, dimension)
                                         : randomPolynomial(dice, dice.whole(1, 3), dimension);
        const Pieces wide = inFourDimensions(one);
        for (int k = 0; k < places; ++k) {
            const Point place = randomPlace(dice, one);
            Point there = {7, 7, 7, 7};
            for (int c = 0; c < dimension; ++c) {
                there[c] = place[c];
            }
            const auto quick = nearestTo(one, place);
            const auto plain = nearestTo(wide, there);
            ASSERT_TRUE(quick && plain);
            ASSERT_NEAR(quick->distance, plain->distance,
                        2e-14 * (7 + farthestOf(one) + norm(place)))
                << "seed " << seed << " piece " << i << " place " << k << ": " << wordsOf(one)
                << " at " << testing::PrintToString(place) << ", u " << quick->spot.u << " and "
                << plain->spot.u;
        }
    }
    std::printf("    nearest, two paths: %d cases, seed %llu\n", pieces * places,
                static_cast<unsigned long long>(seed));
}

TEST(NearestOfRandomPieces, hasManyMinimaWhereTheDegreeIsHigh) {
    constexpr std::uint64_t seed = 25;
    Dice dice(seed);
    constexpr int pieces = casesOf(60);
    for (int i = 0; i < pieces; ++i) {
        const Pieces one = randomPolynomial(dice, dice.whole(15, 25), dice.whole(1, 3));
        SCOPED_TRACE("seed " + std::to_string(seed) + " piece " + std::to_string(i));
        for (int k = 0; k < 4; ++k) {
            ASSERT_NO_FATAL_FAILURE(expectNearest(one, randomPlace(dice, one), 1000));
        }
    }
    std::printf("    nearest, high degree: %d cases, seed %llu\n", 4 * pieces,
                static_cast<unsigned long long>(seed));
}

TEST(NearestIndexLaws, agreeWithNoIndexOnLongCurves) {
    constexpr std::uint64_t seed = 8;
    Dice dice(seed);
    int cases = 0;
    for (const int pieces : {1, 2, 15, 16, 17, 255, 256, 257, 1000, 5000}) {
        const Pieces curve = randomRow(dice, pieces);
        const NearestIndex index(curve);
        for (int k = 0; k < 60; ++k, ++cases) {
            const Point place = randomPlace(dice, curve);
            const double within =
                dice.oneIn(3) ? dice.between(0, 1) : std::numeric_limits<double>::infinity();
            const auto one = nearestTo(curve, place, within);
            const auto other = index.nearest(place, within);
            ASSERT_EQ(one.has_value(), other.has_value())
                << "seed " << seed << " pieces " << pieces;
            if (one) {
                ASSERT_EQ(one->distance, other->distance)
                    << "seed " << seed << " pieces " << pieces;
                ASSERT_EQ(one->spot, other->spot) << "seed " << seed << " pieces " << pieces;
            }
        }
    }
    std::printf("    index: %d cases, seed %llu\n", cases, static_cast<unsigned long long>(seed));
}

/// Curves times a power of two have their distances times it, up to the ends of what doubles hold.
TEST(NearestOfRandomPieces, scales) {
    Dice dice(3);
    for (int i = 0; i < 300; ++i) {
        const Pieces one = randomPiece(dice);
        const Point place = randomPlace(dice, one);
        const auto nearest = nearestTo(one, place);
        for (const double scale : {0x1p990, 0x1p300, 0x1p-300, 0x1p-950}) {
            std::vector<double> bezier(one.bezier().begin(), one.bezier().end());
            const auto width = static_cast<std::size_t>(one[0].width());
            for (std::size_t k = 0; k < bezier.size(); ++k) {
                bezier[k] *= k % width < static_cast<std::size_t>(one.dimension()) ? scale : 1;
            }
            const Pieces scaled = onePiece(one.degree(), one.dimension(), bezier, one.form());
            const auto there = NearestIndex(scaled).nearest(scale * place);
            ASSERT_TRUE(there);
            ASSERT_NEAR(there->distance / scale, nearest->distance,
                        1e-13 * (farthestOf(one) + norm(place)))
                << wordsOf(one) << " at " << testing::PrintToString(place) << " scale " << scale;
        }
    }
}

} // namespace
} // namespace splineloft::testing_curves
