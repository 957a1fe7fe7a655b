#include "core/spline/ladder.h"

#include "core/spline/point.h"
#include "tests/property/random_curves.h"

#include <vector>

namespace splineloft {
namespace {

/// The construction of the lecture's figure 5, in numbers that halve exactly.
TEST(Ladder, isTheConstructionLevelByLevel) {
    const std::vector<Point> points = {{8, 16}, {16, 48}, {48, 48}, {64, 8}};
    const Ladder<Point> ladder(points, 0.5);
    EXPECT_EQ(ladder.degree(), 3);
    EXPECT_EQ(ladder.level(0)[2], Point({48, 48}));
    ASSERT_EQ(ladder.level(1).size(), 3u);
    EXPECT_EQ(ladder.level(1)[0], Point({12, 32}));
    EXPECT_EQ(ladder.level(1)[1], Point({32, 48}));
    EXPECT_EQ(ladder.level(1)[2], Point({56, 28}));
    ASSERT_EQ(ladder.level(2).size(), 2u);
    EXPECT_EQ(ladder.level(2)[0], Point({22, 40}));
    EXPECT_EQ(ladder.level(2)[1], Point({44, 38}));
    ASSERT_EQ(ladder.level(3).size(), 1u);
    EXPECT_EQ(ladder.tip(), Point({33, 39}));
}

TEST(Ladder, ofOnePointIsThatPoint) {
    const std::vector<Point> points = {{8, 16}};
    const Ladder<Point> ladder(points, 0.3);
    EXPECT_EQ(ladder.degree(), 0);
    EXPECT_EQ(ladder.tip(), points[0]);
}

/// The sides of the ladder are the Bézier points of the two halves: the same curve, cut.
TEST(Ladder, cutsThePiece) {
    testing_curves::Dice dice(8);
    for (int degree = 1; degree <= 7; ++degree) {
        std::vector<Point> points;
        for (int i = 0; i <= degree; ++i) {
            points.push_back(Point{100, -40} + dice.pointOnGrid(2, 9));
        }
        const double at = 0.3;
        const Ladder<Point> ladder(points, at);
        std::vector<Point> before, after;
        for (int r = 0; r <= degree; ++r) {
            before.push_back(ladder.level(r).front());
            after.push_back(ladder.level(degree - r).back());
        }
        for (const double u : {0.0, 0.2, 0.7, 1.0}) {
            testing_curves::expectNear(Ladder<Point>(before, u).tip(),
                                       Ladder<Point>(points, at * u).tip(), 1e-12, "before");
            testing_curves::expectNear(Ladder<Point>(after, u).tip(),
                                       Ladder<Point>(points, at + (1 - at) * u).tip(), 1e-12,
                                       "after");
        }
    }
}

TEST(Ladder, ofBlendsHasTheWeightsOfThatOfPoints) {
    const std::vector<Blend> blends = {Blend::of(0), Blend::of(1), Blend::of(2)};
    const Ladder<Blend> ladder(blends, 0.25);
    EXPECT_EQ(ladder.tip().weight(0), 0.5625);
    EXPECT_EQ(ladder.tip().weight(1), 0.375);
    EXPECT_EQ(ladder.tip().weight(2), 0.0625);
}

} // namespace
} // namespace splineloft
