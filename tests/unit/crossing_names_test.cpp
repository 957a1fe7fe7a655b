// Which spots name a crossing where it lies in a joint or in the seam of a closed curve.
#include "core/spline/curve.h"
#include "core/spline/shape/self_intersect.h"

#include "tests/property/random_pieces.h"

#include <cmath>

namespace splineloft {
namespace {

using namespace testing_curves;

/// The points turned about the origin and moved.
std::vector<Point> turned(const std::vector<Point>& points, double angle, const Point& way) {
    std::vector<Point> result;
    for (const auto& p : points) {
        result.push_back(way + Point{p[0] * std::cos(angle) - p[1] * std::sin(angle),
                                     p[0] * std::sin(angle) + p[1] * std::cos(angle)});
    }
    return result;
}

Pieces closedThrough(const std::string& family, const std::vector<Point>& points) {
    Curve curve;
    curve.family = family;
    curve.closed = true;
    curve.ends = familyOf(curve).ends.front();
    for (const auto& point : points) {
        curve.points.append(point);
    }
    return piecesOf(curve);
}

void expectOne(const Pieces& pieces, Spot a, Spot b, const std::string& words) {
    const auto found = selfIntersections(pieces);
    EXPECT_TRUE(found.complete) << words;
    ASSERT_EQ(found.crossings.size(), 1u) << words;
    const auto& crossing = found.crossings[0];
    EXPECT_EQ(crossing.a.segment, a.segment) << words;
    EXPECT_NEAR(crossing.a.u, a.u, a.u == 0 ? 0 : 1e-12) << words;
    EXPECT_EQ(crossing.b.segment, b.segment) << words;
    EXPECT_NEAR(crossing.b.u, b.u, b.u == 0 ? 0 : 1e-12) << words;
}

constexpr const char* throughAllPoints[] = {"linear", "catmull-rom", "cardinal", "natural",
                                            "kochanek-bartels"};

TEST(CrossingNames, atTheSeamAndAtInnerJoints) {
    // A figure eight through its centre twice, begun at each of its points.
    const std::vector<Point> eight = {{0, 0}, {1, 1},  {2, 0},  {1, -1},
                                      {0, 0}, {-1, 1}, {-2, 0}, {-1, -1}};
    for (const char* family : throughAllPoints) {
        for (int turn = 0; turn < roundsOf(100); ++turn) {
            const std::size_t start = static_cast<std::size_t>(turn) % 4;
            auto points = turned(eight, 0.063 * turn, turn % 3 == 0 ? Point{31, -7} : Point{0, 0});
            std::ranges::rotate(points, points.begin() + static_cast<std::ptrdiff_t>(start));
            const std::size_t first = (4 - start) % 4;
            expectOne(closedThrough(family, points), {first, 0}, {first + 4, 0},
                      std::string(family) + ", turn " + std::to_string(turn));
        }
    }
}

TEST(CrossingNames, whereAnotherBranchPassesThroughAJointMidway) {
    // The last leg of the polygon passes through its start, or through its second point.
    for (int turn = 0; turn < roundsOf(100); ++turn) {
        const double angle = 0.063 * turn;
        const std::vector<Point> atSeam = {{0, 0}, {4, 1}, {4, -3}, {0, -2}, {0, 2}, {-3, 2}};
        expectOne(closedThrough("linear", turned(atSeam, angle, {5, 3})), {0, 0}, {3, 0.5},
                  "seam, turn " + std::to_string(turn));
        const std::vector<Point> inside = {{-3, 2}, {0, 0}, {4, 1}, {4, -3}, {0, -2}, {0, 2}};
        expectOne(closedThrough("linear", turned(inside, angle, {5, 3})), {1, 0}, {4, 0.5},
                  "joint, turn " + std::to_string(turn));
        // Points that coincide are a joint of three pieces, one without length.
        const std::vector<Point> twice = {{-3, 2}, {0, 0},  {0, 0}, {4, 1},
                                          {4, -3}, {0, -2}, {0, 2}};
        expectOne(closedThrough("linear", turned(twice, angle, {5, 3})), {2, 0}, {5, 0.5},
                  "double point, turn " + std::to_string(turn));
        const std::vector<Point> seamTwice = {{0, 0}, {4, 1},  {4, -3}, {0, -2},
                                              {0, 2}, {-3, 2}, {0, 0}};
        expectOne(closedThrough("linear", turned(seamTwice, angle, {5, 3})), {0, 0}, {3, 0.5},
                  "double seam, turn " + std::to_string(turn));
    }
}

TEST(CrossingNames, ofACurvedBranchThroughTheSeam) {
    // The arch from (1, -3) over (0, 0) to (-1, -3) passes through the seam of two slanted lines.
    for (int turn = 0; turn < roundsOf(100); ++turn) {
        std::vector<Point> points = {{0, 0},   {2, 2},    {4, 4},   {8, -6}, {1, -3}, {0, 3},
                                     {-1, -3}, {-3, -15}, {-7, -9}, {-4, 4}, {0, 0}};
        points = turned(points, 0.063 * turn, {2, 9});
        points.back() = points.front();
        expectOne(chainOf(2, points), {0, 0}, {2, 0.5}, "turn " + std::to_string(turn));
    }
}

TEST(CrossingNames, areInOrderAndEachOnce) {
    // A star of lines through the origin, each with a joint there: every two of them cross.
    const int lines = 12;
    std::vector<Point> corners;
    for (int i = 0; i < lines; ++i) {
        const double angle = 0.1 + i * 0.25;
        const Point tip = {std::cos(angle), std::sin(angle)};
        corners.push_back(tip);
        corners.push_back({0, 0});
        corners.push_back(-1 * tip);
    }
    const auto found = selfIntersections(chainOf(1, corners));
    std::vector<std::pair<std::size_t, std::size_t>> atOrigin;
    for (const auto& crossing : found.crossings) {
        if (norm(crossing.place) < 1e-9) {
            EXPECT_EQ(crossing.a.u, 0);
            EXPECT_EQ(crossing.b.u, 0);
            atOrigin.emplace_back(crossing.a.segment, crossing.b.segment);
        }
    }
    std::vector<std::pair<std::size_t, std::size_t>> expected;
    for (std::size_t i = 0; i < lines; ++i) {
        for (std::size_t k = i + 1; k < lines; ++k) {
            expected.emplace_back(3 * i + 1, 3 * k + 1);
        }
    }
    EXPECT_EQ(atOrigin, expected);
    const auto all = found.crossings.size();
    EXPECT_TRUE(selfIntersections(chainOf(1, corners), all).complete);
    EXPECT_FALSE(selfIntersections(chainOf(1, corners), all - 1).complete);
    EXPECT_EQ(selfIntersections(chainOf(1, corners), all - 1).crossings.size(), all - 1);
}

} // namespace
} // namespace splineloft
