#include "core/spline/point.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace splineloft {
namespace {

TEST(Point, addsAndScalesCoordinateByCoordinate) {
    const Point a = {1, -2, 3};
    const Point b = {10, 20, 30};
    EXPECT_EQ(a + b, Point({11, 18, 33}));
    EXPECT_EQ(b - a, Point({9, 22, 27}));
    EXPECT_EQ(-2.0 * a, Point({-2, 4, -6}));
    EXPECT_EQ(dot(a, b), 10 - 40 + 90);
}

TEST(Point, holdsUpToSixteenCoordinatesAndAWeight) {
    EXPECT_EQ(Point(16).dimension(), 16);
    const std::vector<double> sixteen(16, 2.0);
    EXPECT_EQ(norm(Point(sixteen)), 8);
    const std::vector<double> withWeight(17, 2.0);
    EXPECT_EQ(Point(withWeight).dimension(), 17);
    const std::vector<double> tooMany(18, 2.0);
    EXPECT_THROW(Point{std::span(tooMany)}, std::invalid_argument);
}

TEST(Point, ofOtherDimensionIsAnother) {
    EXPECT_NE(Point({1, 2}), Point({1, 2, 0}));
}

TEST(Norm, neitherOverflowsNorVanishes) {
    for (const double scale : {1e-320, 1e-300, 1e-160, 1.0, 1e160, 1e300}) {
        EXPECT_NEAR(norm({3 * scale, -4 * scale}) / scale, 5, 1e-3 + (scale < 1e-310 ? 1 : 0))
            << scale;
        EXPECT_GT(norm({scale, 0}), 0) << scale;
    }
    EXPECT_EQ(norm({}), 0);
    EXPECT_EQ(norm({0, 0, 0}), 0);
    EXPECT_EQ(norm({3, std::numeric_limits<double>::infinity()}),
              std::numeric_limits<double>::infinity());
}

TEST(Points, isATableOfRows) {
    Points table = {{1, 2}, {3, 4}, {5, 6}};
    EXPECT_EQ(table.size(), 3u);
    EXPECT_EQ(table.at(1), Point({3, 4}));
    table.insert(1, {9, 9});
    table.erase(0);
    table.append({7, 8});
    table.set(0, {0, -1});
    EXPECT_EQ(table, (Points{{0, -1}, {3, 4}, {5, 6}, {7, 8}}));
}

TEST(Points, refusesRowsOfAnotherLength) {
    Points table = {{1, 2}, {3, 4}};
    EXPECT_THROW(table.append({1, 2, 3}), std::invalid_argument);
    EXPECT_THROW(table.set(1, {1, 2, 3}), std::invalid_argument);
    EXPECT_THROW((Points{{1, 2}, {3}}), std::invalid_argument);
}

TEST(Points, withoutCoordinatesHasNoRows) {
    EXPECT_EQ(Points(0).size(), 0u);
    EXPECT_TRUE(Points(0).empty());
    EXPECT_EQ(Points(std::initializer_list<std::initializer_list<double>>{}).dimension(), 2);
}

} // namespace
} // namespace splineloft
