#include "core/spline/shape/subdivide.h"

#include "tests/property/random_pieces.h"

#include <algorithm>
#include <cmath>

namespace splineloft {
namespace {

using namespace testing_curves;

std::vector<double> numbersOf(const Pieces& pieces) {
    return {pieces.bezier().begin(), pieces.bezier().end()};
}

TEST(Subdivide, aCubicInTheMiddleAsDeCasteljauDrewIt) {
    const Pieces cut = subdivided(pieceOf({{100, 7}, {104, 15}, {112, 15}, {116, 3}}), {0, 0.5});
    EXPECT_EQ(numbersOf(cut), (std::vector<double>{100, 7, 102, 11, 105, 13, 108, 12.5, 108, 12.5,
                                                   111, 12, 114, 9, 116, 3}));
    EXPECT_TRUE(std::ranges::equal(cut.knots().knots(), std::vector{0.0, 0.5, 1.0}));
}

TEST(Subdivide, aRationalArcStaysAnArc) {
    // A quarter of the circle of radius 5 around (20, 30).
    const Pieces arc = pieceOf({{25, 30}, {25, 35}, {20, 35}}, {1, std::sqrt(0.5), 1});
    const Pieces cut = subdivided(arc, {0, 0.3});
    ASSERT_EQ(cut.size(), 2u);
    for (const Spot spot : {Spot{0, 0.2}, Spot{0, 1}, Spot{1, 0.7}}) {
        EXPECT_NEAR(distance(cut.position(spot), {20, 30}), 5, 1e-14);
    }
}

TEST(Subdivide, atJointsAndOutsideThereIsNothingToCut) {
    const Pieces pieces = chainOf(2, {{9, 1}, {8, 4}, {6, 5}, {3, 7}, {1, 9}});
    for (const Spot spot : {Spot{0, 0}, Spot{0, 1}, Spot{1, 0}, Spot{1, 1}, Spot{7, 0.5},
                            Spot{1, std::nan("")}, Spot{0, -3}, Spot{1, 1e300}}) {
        EXPECT_EQ(numbersOf(subdivided(pieces, spot)), numbersOf(pieces)) << spot.u;
    }
    EXPECT_TRUE(subdivided(Pieces(), {}).empty());
    EXPECT_TRUE(reversed(Pieces()).empty());
    EXPECT_TRUE(part(Pieces(), {}, {0, 1}).empty());
}

TEST(Subdivide, knotsNeverFall) {
    // Three coinciding knots near one third, where (1 - u) k + u k is not k.
    const double k = 1.0 / 3;
    const Pieces pieces(1, 1, KnotLine({0, k, k, k, 1}), {5, 6, 6, 7, 7, 8, 8, 9});
    for (int i = 1; i < 100; ++i) {
        const Pieces cut = subdivided(pieces, {2, i / 100.0});
        EXPECT_TRUE(std::ranges::is_sorted(cut.knots().knots())) << i;
    }
    EXPECT_TRUE(std::ranges::is_sorted(reversed(pieces).knots().knots()));
}

TEST(Subdivide, aPartKeepsTheKnotsBetween) {
    const Pieces pieces(1, 1, KnotLine({2, 3, 7, 11}), {5, 6, 6, 9, 9, 1});
    const Pieces middle = part(pieces, {0, 0.5}, {2, 0.25});
    EXPECT_TRUE(std::ranges::equal(middle.knots().knots(), std::vector{2.5, 3.0, 7.0, 8.0}));
    EXPECT_EQ(numbersOf(middle), (std::vector<double>{5.5, 6, 6, 9, 9, 7}));
    EXPECT_EQ(part(pieces, {0, 1}, {2, 0}).size(), 1u) << "from joint to joint";
    EXPECT_EQ(part(pieces, {0, 0}, {2, 1}).size(), 3u);
    EXPECT_TRUE(part(pieces, {1, 0.5}, {1, 0.5}).empty());
    EXPECT_TRUE(part(pieces, {2, 0.5}, {1, 0.5}).empty());
    EXPECT_TRUE(part(pieces, {0, 1}, {1, 0}).empty());
}

TEST(Subdivide, reversedKeepsTheIntervals) {
    const Pieces back = reversed(Pieces(1, 1, KnotLine({2, 3, 7, 11}), {5, 6, 6, 9, 9, 1}));
    EXPECT_TRUE(std::ranges::equal(back.knots().knots(), std::vector{2.0, 6.0, 10.0, 11.0}));
    EXPECT_EQ(numbersOf(back), (std::vector<double>{1, 9, 9, 6, 6, 5}));
}

TEST(Subdivide, hugeAndTinyCoordinatesStayFinite) {
    for (const double size : {1e300, 1.7e308, 1e-300, 5e-324}) {
        const Pieces pieces = pieceOf({{size, -size}, {-size, size}, {size, size}});
        for (const double x : numbersOf(subdivided(pieces, {0, 0.3}))) {
            EXPECT_LE(std::abs(x), size);
        }
        EXPECT_TRUE(std::ranges::all_of(numbersOf(part(pieces, {0, 0.1}, {0, 0.2})),
                                        [](double x) { return std::isfinite(x); }));
    }
}

} // namespace
} // namespace splineloft
