#include "core/spline/shape/self_intersect.h"

#include "tests/property/random_pieces.h"

#include <cmath>
#include <numbers>

namespace splineloft {
namespace {

using namespace testing_curves;

/// (t^2 - c, t (t^2 - c)), which passes one place at t = +-sqrt(c), for t from -1.5 to 1.7: by
/// blossoming, then turned, sheared and moved to there.
std::vector<Point> nodalCubic(double c, const Point& place) {
    const double from = -1.5, to = 1.7;
    std::vector<Point> points;
    for (int k = 0; k <= 3; ++k) {
        const double a = k > 0 ? to : from, b = k > 1 ? to : from, d = k > 2 ? to : from;
        const double x = (a * b + b * d + d * a) / 3 - c;
        const double y = a * b * d - c * (a + b + d) / 3;
        points.push_back(place + Point{2 * x + 0.5 * y, x - 3 * y});
    }
    return points;
}

TEST(SelfIntersections, ofALoop) {
    const auto found = selfIntersections(pieceOf(nodalCubic(1, {103, -57})));
    EXPECT_TRUE(found.complete);
    ASSERT_EQ(found.crossings.size(), 1u);
    EXPECT_NEAR(found.crossings[0].a.u, 0.5 / 3.2, 1e-13);
    EXPECT_NEAR(found.crossings[0].b.u, 2.5 / 3.2, 1e-13);
    expectNear(found.crossings[0].place, {103, -57}, 1e-12, "place");
}

TEST(SelfIntersections, loopsAreFoundUntilTheyAreCusps) {
    for (const double c : {1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6}) {
        const auto found = selfIntersections(pieceOf(nodalCubic(c, {1.3, -0.7})));
        ASSERT_EQ(found.crossings.size(), 1u) << c;
        EXPECT_NEAR(found.crossings[0].a.u, (1.5 - std::sqrt(c)) / 3.2, 1e-15 / c + 1e-12) << c;
    }
    EXPECT_TRUE(selfIntersections(pieceOf(nodalCubic(0, {1.3, -0.7}))).crossings.empty()) << "cusp";
    EXPECT_TRUE(selfIntersections(pieceOf(nodalCubic(-0.1, {1.3, -0.7}))).crossings.empty());
}

TEST(SelfIntersections, ofAPentagram) {
    std::vector<Point> corners;
    for (int i = 0; i <= 5; ++i) {
        const double angle = 0.1 + i * 0.8 * std::numbers::pi;
        corners.push_back({700 + 50 * std::cos(angle), 300 + 50 * std::sin(angle)});
    }
    corners.back() = corners.front();
    const auto found = selfIntersections(chainOf(1, corners));
    EXPECT_TRUE(found.complete);
    ASSERT_EQ(found.crossings.size(), 5u);
    // The inner pentagon's corners lie on a circle of radius 50 / golden ratio^2.
    for (const auto& crossing : found.crossings) {
        EXPECT_NEAR(distance(crossing.place, {700, 300}), 50 / std::pow(std::numbers::phi, 2),
                    1e-11);
    }
}

TEST(SelfIntersections, jointsAreNone) {
    EXPECT_TRUE(selfIntersections(chainOf(1, {{3, 1}, {8, 2}, {5, 9}, {3, 1}})).crossings.empty());
    // Right angles, a corner of 180 degrees at a smooth arc, and a full circle.
    EXPECT_TRUE(selfIntersections(chainOf(1, {{3, 1}, {8, 1}, {8, 9}, {3, 9}})).crossings.empty());
    EXPECT_TRUE(selfIntersections(chainOf(2, {{9, 9}, {12, 9}, {14, 11}, {12, 9}, {9, 8}}))
                    .crossings.empty());
    const double r = std::sqrt(0.5);
    const auto circle = selfIntersections(chainOf(
        2,
        {{25, 30}, {25, 35}, {20, 35}, {15, 35}, {15, 30}, {15, 25}, {20, 25}, {25, 25}, {25, 30}},
        {1, r, 1, r, 1, r, 1, r, 1}));
    EXPECT_TRUE(circle.complete);
    EXPECT_TRUE(circle.crossings.empty());
}

TEST(SelfIntersections, throughAJointOnce) {
    // The corner at (5, 5) lies on the last leg.
    const auto found =
        selfIntersections(chainOf(1, {{1, 5}, {5, 5}, {6, 9}, {9, 9}, {9, 7}, {1, 3}}));
    ASSERT_EQ(found.crossings.size(), 1u);
    EXPECT_EQ(found.crossings[0].a, (Spot{1, 0}));
    expectNear(found.crossings[0].place, {5, 5}, 1e-14, "place");
}

TEST(SelfIntersections, aPlacePassedThreeTimesComesUpThrice) {
    const auto found = selfIntersections(
        chainOf(1, {{1, 5}, {9, 5}, {9, 8}, {5, 8}, {5, 1}, {2, 1}, {2, 2}, {8, 8}}));
    std::size_t there = 0;
    for (const auto& crossing : found.crossings) {
        there += distance(crossing.place, {5, 5}) < 1e-12 ? 1 : 0;
    }
    EXPECT_EQ(there, 3u);
}

TEST(SelfIntersections, ofTwoParabolasThatTouchAndCross) {
    // y = x^2 and y = c - (x - 1/2)^2 with x from -2 to 2, with a wide way around between them.
    const auto curve = [](double c) {
        const auto parabola = [](double x) { return x * x; };
        std::vector<Point> points = {{-2, 4}, {0, -4}, {2, parabola(2)}, {30, 90}, {60, -90}};
        const double end = c - 6.25, start = c - 2.25;
        points.push_back({2, start});         // x = 2
        points.push_back({0, start + 3 * 2}); // along the tangent, of slope -3
        points.push_back({-2, end});
        return points;
    };
    // The tangents' corner at x = 0: start + 3 * 2 = end + 5 * 2.
    for (const double c : {0.125, 0.2, 0.1}) {
        auto points = curve(c);
        points.insert(points.begin() + 5, {50, -20});
        const auto found = selfIntersections(chainOf(2, points));
        std::size_t central = 0;
        for (const auto& crossing : found.crossings) {
            central += crossing.a.segment == 0 ? 1 : 0;
            if (crossing.a.segment == 0 && c == 0.125) {
                expectNear(crossing.place, {0.25, 0.0625}, 1e-8, "touch");
            }
        }
        EXPECT_TRUE(found.complete);
        EXPECT_EQ(central, c > 0.125 ? 2u : (c == 0.125 ? 1u : 0u)) << c;
    }
}

TEST(SelfIntersections, coincidingStretchesAreSaidToBe) {
    for (const Pieces& pieces : {pieceOf({{10, 3}, {0, 3}, {20, 3}, {10, 3}}),
                                 pieceOf({{40, 41}, {0, 1}, {200, 201}, {0, 1}}),
                                 chainOf(1, {{1, 5}, {9, 5}, {9, 8}, {3, 8}, {3, 5}, {8, 5}}),
                                 chainOf(2, {{1, 2}, {3, 9}, {7, 4}, {3, 9}, {1, 2}})}) {
        const auto found = selfIntersections(pieces);
        EXPECT_FALSE(found.complete) << wordsOf(pieces);
        EXPECT_LE(found.crossings.size(), 3u) << wordsOf(pieces);
    }
}

TEST(SelfIntersections, ofAnySize) {
    for (const double size : {1e300, 1e150, 1e-150, 1e-300}) {
        std::vector<Point> points = nodalCubic(1, {10, -5});
        for (auto& point : points) {
            point *= size;
        }
        const auto found = selfIntersections(pieceOf(points));
        ASSERT_EQ(found.crossings.size(), 1u) << size;
        EXPECT_NEAR(found.crossings[0].a.u, 0.5 / 3.2, 1e-12);
    }
}

TEST(SelfIntersections, ofNothingAndPoints) {
    EXPECT_TRUE(selfIntersections(Pieces()).crossings.empty());
    EXPECT_TRUE(selfIntersections(pieceOf({{3, 4}, {3, 4}, {3, 4}})).crossings.empty());
    EXPECT_TRUE(
        selfIntersections(chainOf(1, {{3, 4}, {5, 4}, {5, 4}, {5, 4}, {7, 9}})).crossings.empty())
        << "pieces without length between others";
    EXPECT_TRUE(
        selfIntersections(pieceOf({{1, 2, 3}, {9, 3, 3}, {0, 4, 4}, {5, 0, 9}})).crossings.empty());
}

TEST(SelfIntersections, ofThousandsOfPieces) {
    // Arches side by side in a long row, and a line back through all of them.
    std::vector<Point> points;
    for (int i = 0; i <= 6000; ++i) {
        points.push_back({100.0 + i, i % 2 == 0 ? 7.0 : (i % 4 == 1 ? 9.0 : 5.0)});
    }
    points.push_back({6200, 30});
    points.push_back({6200, 7.5});
    points.push_back({3000, 7.5});
    points.push_back({90, 7.5});
    const auto found = selfIntersections(chainOf(2, points));
    EXPECT_TRUE(found.complete);
    EXPECT_EQ(found.crossings.size(), 3001u) << "two for every other arch, and one";
    EXPECT_FALSE(selfIntersections(chainOf(2, points), 10).complete);
}

} // namespace
} // namespace splineloft
