// Self-intersections of curves that are much work, and of those that would be without end.
#include "core/spline/curve.h"
#include "core/spline/shape/arc_pairs.h"
#include "core/spline/shape/self_intersect.h"

#include "tests/cases.h"
#include "tests/property/random_pieces.h"

#include <cmath>
#include <numbers>

namespace splineloft {
namespace {

using namespace testing_curves;

Pieces openThrough(const std::string& family, const std::vector<Point>& points) {
    Curve curve;
    curve.family = family;
    curve.ends = familyOf(curve).ends.front();
    for (const auto& point : points) {
        curve.points.append(point);
    }
    return piecesOf(curve);
}

std::vector<Point> toAndFro(int count) {
    std::vector<Point> points;
    for (int i = 0; i < count; ++i) {
        points.push_back({1.0 * (i % 2), 1.0 * (i % 2)});
    }
    return points;
}

/// Round an octagon again and again.
std::vector<Point> laps(int count) {
    std::vector<Point> points;
    for (int i = 0; i < count; ++i) {
        const double angle = 0.1 + (i % 8) * 0.25 * std::numbers::pi;
        points.push_back({3 * std::cos(angle), 3 * std::sin(angle)});
    }
    return points;
}

TEST(HeavyCrossings, ofCurvesThatRetraceThemselves) {
    // Tenfold sizes take a hundred times as long where every pair of pieces is searched.
    const int count = underSanitizers ? 300 : 3000;
    const auto retraced = selfIntersections(openThrough("linear", toAndFro(count)));
    EXPECT_FALSE(retraced.complete);
    EXPECT_TRUE(retraced.crossings.empty());
    EXPECT_FALSE(selfIntersections(openThrough("catmull-rom", laps(count / 3))).complete);
    EXPECT_FALSE(selfIntersections(openThrough("natural", laps(count / 10))).complete);
}

TEST(HeavyCrossings, endWhenThereIsNoEndOfWork) {
    const int count = underSanitizers ? 2000 : 100'000;
    EXPECT_FALSE(selfIntersections(openThrough("linear", toAndFro(count))).complete);
}

TEST(HeavyCrossings, ofAWeaveAreAllFound) {
    // A zigzag from left to right and one from bottom to top: every leg of one crosses every leg of
    // the other.
    const int legs = underSanitizers ? 31 : 315;
    std::vector<Point> points;
    const double size = legs + 1;
    for (int i = 0; i <= legs; ++i) {
        points.push_back({1.0 * i, i % 2 == 0 ? size : -1});
    }
    points.push_back({size + 5, -5});
    for (int i = 0; i <= legs; ++i) {
        points.push_back({i % 2 == 0 ? size : -1, i + 0.3});
    }
    const auto found = selfIntersections(openThrough("linear", points));
    EXPECT_TRUE(found.complete);
    EXPECT_EQ(found.crossings.size(),
              static_cast<std::size_t>(legs) * static_cast<std::size_t>(legs));
}

TEST(HeavyCrossings, rowsAndPilesAreLittleWork) {
    const int count = 100'000;
    for (const bool tall : {false, true}) {
        std::vector<Point> points;
        for (int i = 0; i < count; ++i) {
            const double along = i, across = i % 2;
            points.push_back(tall ? Point{across, along} : Point{along, across});
        }
        const Pieces pieces = openThrough("linear", points);
        const auto arcs = arcsOf(pieces);
        ArcPairs pairs(arcs);
        constexpr std::int64_t plenty = 1'000'000'000;
        std::int64_t work = plenty;
        int found = 0;
        while (const auto pair = pairs.next(work)) {
            EXPECT_EQ(pair->first + 1, pair->second);
            ++found;
        }
        EXPECT_EQ(found, count - 2) << "neighbours share their joint";
        EXPECT_LT(plenty - work, 20 * count);
        const auto crossings = selfIntersections(pieces);
        EXPECT_TRUE(crossings.complete);
        EXPECT_TRUE(crossings.crossings.empty());
    }
}

TEST(HeavyCrossings, pairsEndWithTheWork) {
    const auto arcs = arcsOf(openThrough("linear", toAndFro(5000)));
    ArcPairs pairs(arcs);
    std::int64_t work = 10'000;
    int found = 0;
    while (pairs.next(work)) {
        ++found;
    }
    EXPECT_EQ(work, 0);
    EXPECT_GT(found, 1000);
    EXPECT_LT(found, 10'000);
}

TEST(ArcOverlaps, endWhereAnArcEnds) {
    // Stretches of the parabola y = x^2, whose Bézier points are (a, a^2), ((a + b) / 2, a b) and
    // (b, b^2), as arcs of a piece each.
    const auto arcOf = [](double from, double to) {
        return arcsOf(pieceOf({{from, from * from}, {(from + to) / 2, from * to}, {to, to * to}}))
            .front();
    };
    const Pieces any = pieceOf({{0, 0}, {1, 1}, {2, 3}});
    const auto overlap = overlapOf(arcOf(0.55, 0.8), arcOf(0.95, 0.6), any[0]);
    ASSERT_TRUE(overlap);
    EXPECT_NEAR(overlap->a[0], 0.2, 1e-14);
    EXPECT_NEAR(overlap->b[0], 1, 1e-14);
    EXPECT_NEAR(overlap->a[1], 1, 1e-14);
    EXPECT_NEAR(overlap->b[1], 0.15 / 0.35, 1e-14);
    EXPECT_FALSE(overlapOf(arcOf(0.55, 0.8), arcOf(0.8, 0.95), any[0])) << "one place in common";
    EXPECT_FALSE(overlapOf(arcOf(0.55, 0.7), arcOf(0.8, 0.95), any[0]));
    const auto chord = arcsOf(pieceOf({{0.55, 0.3025}, {0.675, 0.47125}, {0.8, 0.64}})).front();
    EXPECT_FALSE(overlapOf(arcOf(0.55, 0.8), chord, any[0])) << "both ends in common";
}

} // namespace
} // namespace splineloft
