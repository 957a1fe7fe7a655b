#include "core/spline/shape/intersect.h"

#include "tests/property/random_pieces.h"

#include <cmath>

namespace splineloft {
namespace {

using namespace testing_curves;

void expectSpots(const std::vector<Spot>& found, const std::vector<Spot>& wanted,
                 const std::string& what) {
    ASSERT_EQ(found.size(), wanted.size()) << what;
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        EXPECT_EQ(found[i].segment, wanted[i].segment) << what;
        EXPECT_NEAR(found[i].u, wanted[i].u, 1e-13) << what;
    }
}

TEST(Crossings, ofAParabolaAndALine) {
    // y = 50 + (x - 100)^2 for x from 99 to 103, and y = x - 50.24: x - 100 = 0.4 and 0.6.
    const Pieces parabola = pieceOf({{99, 51}, {101, 47}, {103, 59}});
    const auto line = lineThrough({90, 39.76}, {110, 59.76});
    ASSERT_TRUE(line);
    const auto found = crossings(parabola, *line);
    ASSERT_EQ(found.spots.size(), 2u);
    EXPECT_NEAR(found.spots[0].u, 1.4 / 4, 1e-12);
    EXPECT_NEAR(found.spots[1].u, 1.6 / 4, 1e-12);
    // The tangent at x = 101.
    expectSpots(crossings(parabola, *lineThrough({101, 51}, {100, 49})).spots, {{0, 0.5}}, "touch");
    EXPECT_TRUE(crossings(parabola, *lineThrough({0, 49.9}, {1, 49.9})).spots.empty());
}

TEST(Crossings, ofACircle) {
    const Pieces arc = pieceOf({{25, 30}, {25, 35}, {20, 35}}, {1, std::sqrt(0.5), 1});
    const auto found = crossings(arc, {{20, 33}, {0, 7}}).spots; // y = 33, where x = 24
    ASSERT_EQ(found.size(), 1u);
    expectNear(arc.position(found[0]), {24, 33}, 1e-13, "3, 4, 5");
}

TEST(Crossings, atJointsOnce) {
    const Pieces zigzag = chainOf(1, {{3, 1}, {5, 4}, {7, 1}, {9, 4}});
    expectSpots(crossings(zigzag, {{0, 4}, {0, 1}}).spots, {{1, 0}, {2, 1}}, "top");
    expectSpots(crossings(zigzag, {{5, 0}, {1, 0}}).spots, {{1, 0}}, "through a corner");
    const Pieces triangle = chainOf(1, {{3, 1}, {8, 2}, {5, 9}, {3, 1}});
    expectSpots(crossings(triangle, {{3, 1}, {1, 0}}).spots, {{0, 0}}, "start of a closed curve");
    const Pieces open = chainOf(1, {{3, 1}, {8, 2}, {5, 9}, {3, 1.5}});
    expectSpots(crossings(open, {{3, 1}, {1, 0}}).spots, {{0, 0}, {2, 1}}, "both ends");
    // A tenth and two tenths are not thirds of three tenths: both sides of the joint round.
    const Pieces rounded(1, 2, KnotLine({0, 1, 2}), {0.1, 5, 0.1 + 0.2, 7, 0.3, 7, 0.7, 8});
    expectSpots(crossings(rounded, {{0.3, 0}, {1, 0}}).spots, {{1, 0}}, "rounding");
}

TEST(Crossings, piecesInTheLineAreNamed) {
    const Pieces step = chainOf(1, {{3, 1}, {5, 4}, {7, 4}, {9, 1}});
    const auto found = crossings(step, {{-20, 4}, {0, 3}});
    EXPECT_EQ(found.within, std::vector<std::size_t>{1});
    expectSpots(found.spots, {{0, 1}, {2, 0}}, "its neighbours");
    // There and back in the line itself, off the axes.
    const auto along = crossings(pieceOf({{40, 41}, {0, 1}, {200, 201}, {0, 1}}),
                                 *lineThrough({-7, -6}, {100, 101}));
    EXPECT_TRUE(along.spots.empty());
    EXPECT_EQ(along.within, std::vector<std::size_t>{0});
}

TEST(Crossings, farFromTheOriginAndOfAnySize) {
    for (const double size : {1e300, 1e-300}) {
        const Pieces pieces = pieceOf({{0, 0}, {size, 2 * size}, {2 * size, 0}});
        const auto line = lineThrough({0, 0.75 * size}, {size, 0.75 * size});
        ASSERT_TRUE(line);
        expectSpots(crossings(pieces, *line).spots, {{0, 0.25}, {0, 0.75}}, "size");
    }
    const Pieces far = pieceOf({{1e9, 1e9}, {1e9 + 1, 1e9 + 2}, {1e9 + 2, 1e9}});
    const auto found = crossings(far, {{0, 1e9 + 0.75}, {0, 1}}).spots;
    ASSERT_EQ(found.size(), 2u);
    EXPECT_NEAR(found[0].u, 0.25, 1e-12);
    ASSERT_TRUE(lineThrough({-1.7e308, -1.7e308}, {1.7e308, 1.7e308}));
    EXPECT_NEAR(lineThrough({-1.7e308, -1.7e308}, {1.7e308, 1.7e308})->normal[1], std::sqrt(0.5),
                1e-15);
}

TEST(Crossings, nothingWhereThereIsNoLine) {
    const Pieces pieces = pieceOf({{1, 2}, {3, 4}, {0, 9}});
    EXPECT_FALSE(lineThrough({3, 4}, {3, 4}));
    EXPECT_FALSE(lineThrough({3, 4, 5}, {3, 4, 6}));
    EXPECT_TRUE(crossings(pieces, {{1, 2}, {0, 0}}).spots.empty());
    EXPECT_TRUE(crossings(pieces, {{1, 2}, {std::nan(""), 1}}).spots.empty());
    EXPECT_TRUE(crossings(pieces, {{1, 2, 3}, {0, 1, 1}}).spots.empty());
    EXPECT_TRUE(crossings(Pieces(), {{1, 2}, {0, 1}}).spots.empty());
    EXPECT_EQ(crossings(pieceOf({{3, 4}, {3, 4}}), {{3, 9}, {1, 0}}).within.size(), 1u);
}

} // namespace
} // namespace splineloft
