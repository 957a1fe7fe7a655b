#include "core/spline/shape/flatten.h"

#include "tests/property/random_pieces.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace splineloft {
namespace {

using namespace testing_curves;

/// The farthest that the curve is from its polyline, from many spots between each two.
double farthestOff(const Pieces& pieces, const Polyline& line) {
    double farthest = 0;
    for (std::size_t k = 0; k + 1 < line.spots.size(); ++k) {
        const Spot a = line.spots[k];
        const double end = line.spots[k + 1].segment == a.segment ? line.spots[k + 1].u : 1;
        const Point start = pieces.position(a);
        const Point chord = pieces.position(line.spots[k + 1]) - start;
        for (int i = 1; i < 64; ++i) {
            const Point way = pieces.position({a.segment, std::lerp(a.u, end, i / 64.0)}) - start;
            const double squared = dot(chord, chord);
            const double along =
                squared > 0 ? std::clamp(dot(way, chord) / squared, 0.0, 1.0) : 0.0;
            farthest = std::max(farthest, norm(way - along * chord));
        }
    }
    return farthest;
}

TEST(Flatten, aParabolaNeedsAsManyChordsAsTheoryHas) {
    // |P''| = 32 by u: n chords are off by 32 / (8 n^2).
    const Pieces parabola = pieceOf({{99, 51}, {101, 47}, {103, 59}});
    for (const int n : {1, 2, 5, 30, 300}) {
        const Polyline line = flattened(parabola, 4.0 / (n * n) * 1.0001);
        EXPECT_TRUE(line.withinTolerance);
        // Across its axis the distance is less than along it: less than n chords may do.
        EXPECT_LE(line.spots.size(), static_cast<std::size_t>(n) + 2) << n;
    }
}

TEST(Flatten, aCircleNeedsFewerChordsThanOneInTwentyMore) {
    std::vector<Point> points;
    std::vector<double> weights;
    const Point corners[] = {{25, 30}, {25, 35}, {20, 35}, {15, 35}, {15, 30},
                             {15, 25}, {20, 25}, {25, 25}, {25, 30}};
    for (int i = 0; i < 9; ++i) {
        points.push_back(corners[i]);
        weights.push_back(i % 2 == 0 ? 1 : std::sqrt(0.5));
    }
    const Pieces circle = chainOf(2, points, weights);
    for (const double tolerance : {1e-1, 1e-2, 1e-4, 1e-6}) {
        const Polyline line = flattened(circle, tolerance);
        EXPECT_TRUE(line.withinTolerance);
        const double least = 3.14159265 / std::acos(1 - tolerance / 5); // chords of a full circle
        EXPECT_LE(static_cast<double>(line.spots.size()), 1.05 * least + 5) << tolerance;
        EXPECT_LE(farthestOff(circle, line), tolerance * (1 + 1e-9));
    }
}

TEST(Flatten, wildCurvesStayWithinTolerance) {
    const std::vector<std::vector<Point>> wild = {
        {{0, 0}, {1, 1}, {0, 1}, {1, 0}},                        // cusp
        {{0, 0}, {30, 1}, {-29, 1}, {1, 0}},                     // loop
        {{10, 0}, {0, 0}, {20, 0}, {10, 0}},                     // there and back
        {{0, 0}, {1e-2, 0}, {-1e-2, 0}, {0, 0}},                 // ends where it starts
        {{40, 40}, {0, 0}, {200, 200}, {0, 0}},                  // beyond its ends
        {{1, 1}, {1, 1}, {1, 1}, {9, 3}},                        // starts at rest
        {{5, 5, 1}, {6, 7, 8}, {2, 9, 4}, {5, 5, 5}, {1, 2, 9}}, // in space
    };
    for (const auto& points : wild) {
        const Pieces pieces = pieceOf(points);
        for (const double relative : {1e-1, 1e-3, 1e-6}) {
            const double tolerance = relative * extentOf(pieces);
            const Polyline line = flattened(pieces, tolerance);
            EXPECT_TRUE(line.withinTolerance) << testing::PrintToString(points[1]);
            EXPECT_LE(farthestOff(pieces, line), tolerance * (1 + 1e-9))
                << testing::PrintToString(points[1]);
            EXPECT_LE(line.spots.size(), 4 / std::sqrt(relative) + 8);
        }
    }
}

TEST(Flatten, noToleranceCanLoop) {
    const Pieces wave = chainOf(3, {{7, 3}, {9, 8}, {4, 5}, {1, 1}, {-2, -3}, {5, 5}, {6, 0}});
    for (const double tolerance : {0.0, -1.0, std::nan(""), 1e-18, 1e-300, 5e-324}) {
        const Polyline line = flattened(wave, tolerance, 1000);
        EXPECT_FALSE(line.withinTolerance) << tolerance;
        EXPECT_LE(line.spots.size(), 1000u);
        EXPECT_GE(line.spots.size(), 900u);
        EXPECT_EQ(line.spots.back(), (Spot{1, 1}));
    }
    EXPECT_FALSE(flattened(wave, 1e-14).withinTolerance) << "and that quickly, with 100000 spots";
    EXPECT_EQ(flattened(wave, std::numeric_limits<double>::infinity()).spots.size(), 3u);
    EXPECT_FALSE(flattened(wave, 1e-6, 50).withinTolerance) << "too many";
}

TEST(Flatten, mostIsNeverExceeded) {
    std::vector<Point> points;
    for (int i = 0; i <= 200; ++i) {
        points.push_back({i * 0.5, std::sin(i)});
    }
    const Pieces pieces = chainOf(2, points);
    for (std::size_t most = 0; most < 400; most += 7) {
        for (const double tolerance : {0.0, 1e-3, 1e-2, 10.0}) {
            const Polyline line = flattened(pieces, tolerance, most);
            EXPECT_LE(line.spots.size(), std::max<std::size_t>(most, 2));
            EXPECT_GE(line.spots.size(), 2u);
            EXPECT_EQ(line.spots.back(), (Spot{99, 1}));
        }
    }
}

TEST(Flatten, straightLinesNeedNoMoreWhateverTheTolerance) {
    const Pieces line = chainOf(1, {{1000.1, 7}, {1001.3, 9}, {999.2, 4}});
    EXPECT_EQ(flattened(line, 0).spots.size(), 3u);
    EXPECT_TRUE(flattened(line, 0).withinTolerance);
    EXPECT_TRUE(flattened(pieceOf({{3, 4}, {3, 4}, {3, 4}}), 0).withinTolerance);
    EXPECT_EQ(flattened(pieceOf({{3, 4}, {3, 4}, {3, 4}}), 0).spots.size(), 2u);
    EXPECT_TRUE(flattened(Pieces(), 1).spots.empty());
}

TEST(Flatten, hugeAndTinyCurvesTakeAsManyAsOthers) {
    const auto countOf = [](double size) {
        const Pieces pieces =
            pieceOf({{0, 0}, {size, 2 * size}, {-size, 1.5 * size}, {1.5 * size, -size}});
        const Polyline line = flattened(pieces, 1e-4 * size);
        EXPECT_TRUE(line.withinTolerance) << size;
        return line.spots.size();
    };
    for (const double size : {1e300, 5e307, 1e150, 1e-150, 1e-300}) {
        EXPECT_NEAR(static_cast<double>(countOf(size)), static_cast<double>(countOf(1)), 1) << size;
    }
    const Polyline screen = flattened(pieceOf({{0, 0}, {1e300, 2e300}, {3e300, 0}}), 0.25);
    EXPECT_FALSE(screen.withinTolerance);
    EXPECT_LE(screen.spots.size(), mostFlatSpots);
}

TEST(Flatten, bothSidesOfAGap) {
    const Pieces torn(1, 2, KnotLine({0, 1, 2}), {1, 1, 2, 2, 5, 5, 7, 5});
    const std::vector<Spot> wanted = {{0, 0}, {0, 1}, {1, 0}, {1, 1}};
    EXPECT_EQ(flattened(torn, 0.1).spots, wanted);
}

} // namespace
} // namespace splineloft
