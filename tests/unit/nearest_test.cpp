// The nearest spot against trying very many.
#include "core/spline/measure/bounds.h"
#include "core/spline/measure/nearest.h"

#include "tests/property/hard_pieces.h"
#include "tests/property/random_curves.h"

#include <cmath>
#include <limits>

namespace splineloft {
namespace {

using namespace testing_curves;

/// The least distance of `perPiece` spots of each piece.
double bruteForce(const Pieces& pieces, const Point& place, int perPiece) {
    double best = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        for (int k = 0; k <= perPiece; ++k) {
            const Spot spot{i, static_cast<double>(k) / perPiece};
            best = std::min(best, distance(pieces.position(spot), place));
        }
    }
    return best;
}

class NearestLaws : public EveryFamily {};

TEST_P(NearestLaws, noSpotIsNearer) {
    forEveryForm(GetParam(), 6, [](const Curve& curve) {
        const Pieces pieces = piecesOf(curve);
        Dice dice(curve.points.size());
        for (int round = 0; round < 6; ++round) {
            const Point place = curve.points.at(0) + dice.pointOnGrid(pieces.dimension(), 20);
            const auto nearest = nearestTo(pieces, place);
            ASSERT_TRUE(nearest);
            EXPECT_EQ(nearest->distance, distance(pieces.position(nearest->spot), place));
            EXPECT_LE(nearest->distance, bruteForce(pieces, place, 1000) * (1 + 1e-12))
                << "round " << round;
        }
    });
}

TEST_P(NearestLaws, aSpotOfTheCurveIsItsOwnNearest) {
    forEveryForm(GetParam(), 6, [](const Curve& curve) {
        const Pieces pieces = piecesOf(curve);
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            for (const double u : {0.0, 0.03, 0.41, 0.5, 0.98, 1.0}) {
                const auto nearest = nearestTo(pieces, pieces.position({i, u}));
                ASSERT_TRUE(nearest);
                // Bisection leaves u to 1e-15, and positions carry their rounding.
                EXPECT_LE(nearest->distance, 1e-13 * (1 + farthest(curve)) * pieces.degree())
                    << "segment " << i << " u " << u;
            }
        }
    });
}

TEST(Nearest, ofNothingIsNothing) {
    EXPECT_FALSE(nearestTo(Pieces(), Point{1, 2}));
    EXPECT_FALSE(hullBox(Pieces()));
}

TEST(Nearest, ofALineIsTheFootOfThePerpendicularOrAnEnd) {
    Curve curve;
    curve.family = "linear";
    curve.ends = Ends::none;
    curve.points = {{100, 50}, {108, 56}};
    const Pieces pieces = piecesOf(curve);
    const auto foot = nearestTo(pieces, {104 - 3, 53 + 4});
    EXPECT_NEAR(foot->distance, 5, 1e-13);
    EXPECT_NEAR(foot->spot.u, 0.5, 1e-13);
    EXPECT_EQ(nearestTo(pieces, {90, 50})->spot, (Spot{0, 0}));
    EXPECT_EQ(nearestTo(pieces, {200, 200})->spot, (Spot{0, 1}));
}

/// Hard pieces: cusps, loops, legs there and back. The two sides of a cusp both come near.
TEST(Nearest, onCuspsAndLoops) {
    const std::vector<Points> hard = {{{0, 0}, {1, 1}, {0, 1}, {1, 0}},
                                      {{0, 0}, {30, 1}, {-29, 1}, {1, 0}},
                                      {{0, 0}, {10, 10}, {-9, 10}, {1, 0}},
                                      {{0, 0}, {4, 0}, {4, 0}, {0, 0.001}},
                                      {{0, 0}, {1.02, 1}, {-0.02, 1}, {1, 0}}};
    Dice dice(11);
    for (std::size_t i = 0; i < hard.size(); ++i) {
        Curve curve;
        curve.family = "bezier";
        curve.ends = Ends::none;
        curve.points = hard[i];
        const Pieces pieces = piecesOf(curve);
        for (int round = 0; round < 300; ++round) {
            const Point around = pieces.position({0, dice.between(0, 1)});
            const Point place = around + dice.pointOnGrid(2, dice.oneIn(2) ? 0.05 : 1);
            EXPECT_LE(nearestTo(pieces, place)->distance,
                      bruteForce(pieces, place, 4000) * (1 + 1e-12))
                << "piece " << i << " at " << testing::PrintToString(place);
        }
    }
}

TEST(Nearest, ofTheExactCircle) {
    const Point center = {7, -3};
    const Pieces circle = testing_curves::circle(center, 2.5);
    const NearestIndex index(circle);
    Dice dice(12);
    for (int round = 0; round < 500; ++round) {
        const Point away = dice.pointOnGrid(2, 5);
        const double off = std::abs(norm(away) - 2.5);
        const auto nearest = index.nearest(center + away);
        ASSERT_TRUE(nearest);
        EXPECT_NEAR(nearest->distance, off, 1e-14 * 10) << testing::PrintToString(away);
        const Point wanted = center + 2.5 / norm(away) * away;
        if (norm(away) > 0.01) {
            EXPECT_LE(distance(circle.position(nearest->spot), wanted), 1e-11);
        }
    }
    EXPECT_NEAR(nearestTo(circle, center)->distance, 2.5, 1e-14) << "from its center";
    EXPECT_NEAR(index.nearest(center)->distance, 2.5, 1e-14) << "from its center";
}

TEST(Nearest, withinCountsOnlyWhatIsNearer) {
    const Pieces line = testing_curves::onePiece(1, 2, {0, 0, 10, 0});
    const NearestIndex index(line);
    EXPECT_TRUE(nearestTo(line, {5, 3}, 3.001));
    EXPECT_FALSE(nearestTo(line, {5, 3}, 3));
    EXPECT_FALSE(nearestTo(line, {5, 3}, 0));
    EXPECT_FALSE(nearestTo(line, {5, 3}, -10)) << "not as far as its size";
    EXPECT_TRUE(index.nearest({5, 3}, 3.001));
    EXPECT_FALSE(index.nearest({5, 3}, 3));
    EXPECT_FALSE(index.nearest({5, 3}, -10));
}

TEST(Nearest, ofNoPlaceIsNothing) {
    const Pieces line = testing_curves::onePiece(1, 2, {0, 0, 10, 0});
    const double infinity = std::numeric_limits<double>::infinity();
    for (const auto& place : {Point{std::nan(""), 1}, Point{0, infinity}}) {
        EXPECT_FALSE(nearestTo(line, place));
        EXPECT_FALSE(NearestIndex(line).nearest(place));
    }
    EXPECT_FALSE(NearestIndex(Pieces()).nearest({1, 2}));
}

TEST(Nearest, ofRestingPieces) {
    const Pieces point = testing_curves::onePiece(3, 2, {4, 7, 4, 7, 4, 7, 4, 7});
    EXPECT_DOUBLE_EQ(nearestTo(point, {7, 11})->distance, 5);
    EXPECT_EQ(nearestTo(point, {4, 7})->distance, 0);
    EXPECT_EQ(nearestTo(point, {4, 7})->spot, Spot{});
    EXPECT_DOUBLE_EQ(NearestIndex(point).nearest({7, 11})->distance, 5);
}

TEST(Nearest, ofEquallyNearSpotsIsTheFirst) {
    // There and back: every spot is there twice.
    const Pieces back(1, 2, KnotLine({0, 1, 2}), {0, 0, 8, 0, 8, 0, 0, 0});
    EXPECT_EQ(nearestTo(back, {2, 1})->spot, (Spot{0, 0.25}));
    EXPECT_EQ(NearestIndex(back).nearest({2, 1})->spot, (Spot{0, 0.25}));
    EXPECT_EQ(nearestTo(back, {9, 1})->spot, (Spot{0, 1})) << "at a joint, the piece that ends";
}

TEST(Nearest, atTheEndsOfWhatDoublesHold) {
    const double most = std::numeric_limits<double>::max();
    for (const double size : {most, 1e300, 1e-300, 5e-324}) {
        const Pieces pieces =
            testing_curves::onePiece(3, 2, {-size, -size, size, size, -size, size, size, -size});
        for (const auto& place : {Point{0, 0}, Point{size, size}, Point{1, 1}, Point{-most, most},
                                  Point{1e-300, -1e-300}}) {
            const auto nearest = nearestTo(pieces, place);
            ASSERT_TRUE(nearest) << size;
            EXPECT_TRUE(std::isfinite(nearest->distance)) << size;
            EXPECT_TRUE(nearest->spot.u >= 0 && nearest->spot.u <= 1) << size;
            EXPECT_TRUE(NearestIndex(pieces).nearest(place)) << size;
        }
    }
}

TEST(Nearest, boxHoldsTheCurve) {
    for (const auto& form : everyForm()) {
        const Curve curve = randomCurve(form, 5);
        const Pieces pieces = piecesOf(curve);
        const auto box = hullBox(pieces);
        ASSERT_TRUE(box) << wordsOf(curve);
        const double rounding = 1e-14 * (1 + farthest(curve));
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            const Point p = pieces.position({i, 0.37});
            for (int c = 0; c < p.dimension(); ++c) {
                EXPECT_GE(p[c], box->low[c] - rounding) << wordsOf(curve);
                EXPECT_LE(p[c], box->high[c] + rounding) << wordsOf(curve);
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Families, NearestLaws, testing::ValuesIn(familyIds()), testNameOf);

} // namespace
} // namespace splineloft
