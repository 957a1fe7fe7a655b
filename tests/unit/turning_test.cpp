#include "core/spline/shape/turning.h"

#include "tests/property/random_pieces.h"

#include <cmath>
#include <tuple>

namespace splineloft {
namespace {

using namespace testing_curves;

/// The cubic with this x and y in t as power coefficients (constant first), for t from `from` to
/// `to`: by blossoming. Then turned, sheared and moved, so that nothing lies along an axis.
Pieces cubicOf(const std::vector<double>& x, const std::vector<double>& y, double from, double to) {
    std::vector<Point> points;
    for (int k = 0; k <= 3; ++k) {
        const double a = k > 0 ? to : from, b = k > 1 ? to : from, c = k > 2 ? to : from;
        const double blossoms[] = {1, (a + b + c) / 3, (a * b + b * c + c * a) / 3, a * b * c};
        Point p(2);
        for (std::size_t i = 0; i < 4; ++i) {
            p += blossoms[i] * Point{x[i], y[i]};
        }
        points.push_back({103 + 2 * p[0] + 0.5 * p[1], -57 + p[0] - 3 * p[1]});
    }
    return pieceOf(points);
}

void expectSpots(const std::vector<Spot>& found, const std::vector<double>& wanted,
                 double tolerance, const std::string& what) {
    ASSERT_EQ(found.size(), wanted.size()) << what;
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        EXPECT_NEAR(static_cast<double>(found[i].segment) + found[i].u, wanted[i], tolerance)
            << what;
    }
}

TEST(Inflections, ofTheGraphOfACube) {
    // y = t^3 bends the other way at t = 0, here at u = 1 / 4.
    expectSpots(inflections(cubicOf({0, 1, 0, 0}, {0, 0, 0, 1}, -1, 3)), {0.25}, 1e-13, "cube");
    // A rational cubic, x = t / (1 + t^2), y = 1 / (1 + t^2) * t^2: an arc, without any.
    EXPECT_TRUE(inflections(pieceOf({{25, 30}, {25, 35}, {20, 35}}, {1, 0.7, 1})).empty());
}

TEST(Inflections, ofASerpentine) {
    // y = t / (1 + t^2), as (t (1 + t^2), t) over 1 + t^2, moved: y'' is zero at t = 0 and at
    // t = +-sqrt(3). Over ranges of t that keep the weights of the Bézier points above zero.
    for (const auto& [low, high, wanted] :
         {std::tuple{-0.9, 0.8, std::vector{0.9 / 1.7}},
          std::tuple{1.0, 3.0, std::vector{(std::sqrt(3.0) - 1) / 2}}}) {
        std::vector<Point> points;
        std::vector<double> weights;
        for (int k = 0; k <= 3; ++k) {
            const double a = k > 0 ? high : low, b = k > 1 ? high : low, c = k > 2 ? high : low;
            const double t1 = (a + b + c) / 3, t2 = (a * b + b * c + c * a) / 3, t3 = a * b * c;
            weights.push_back(1 + t2);
            points.push_back({40 + (t1 + t3) / (1 + t2), 20 + t1 / (1 + t2)});
        }
        expectSpots(inflections(pieceOf(points, weights)), wanted, 1e-12, "serpentine");
    }
}

TEST(Inflections, atJointsOnce) {
    // A left turn and then a right turn, smoothly and at a corner.
    const std::vector<double> one = {1};
    expectSpots(inflections(chainOf(2, {{9, 9}, {10, 9}, {11, 10}, {12, 11}, {13, 11}})), one, 0,
                "smooth");
    expectSpots(inflections(chainOf(2, {{9, 9}, {10, 9}, {11, 10}, {11, 14}, {13, 15}})), one, 0,
                "corner");
    // With a straight stretch between: at its far end.
    expectSpots(inflections(chainOf(
                    2, {{9, 9}, {10, 9}, {11, 10}, {12, 11}, {13, 12}, {14, 13}, {15, 13}})),
                {2}, 0, "straight stretch");
    EXPECT_TRUE(inflections(chainOf(2, {{9, 9}, {10, 9}, {11, 10}, {12, 11}, {12, 12}})).empty());
}

TEST(Inflections, ofAClosedCurveAtItsStart) {
    // An S of two arcs, closed by two more that do not change sides: two changes, one at the start.
    const Pieces closed = chainOf(
        2, {{9, 9}, {10, 8}, {11, 9}, {12, 10}, {13, 9}, {13, 20}, {11, 20}, {9, 20}, {9, 9}});
    expectSpots(inflections(closed), {1, 2}, 0, "closed");
    const Pieces startsAtChange = chainOf(
        2, {{11, 9}, {12, 10}, {13, 9}, {13, 20}, {11, 20}, {9, 20}, {9, 9}, {10, 8}, {11, 9}});
    expectSpots(inflections(startsAtChange), {0, 1}, 0, "closed, from elsewhere");
}

/// Cubics that broke strokers (numbers from kurbo's and Skia's tests), with their standstills.
struct Broken {
    std::vector<Point> points;
    std::vector<double> cusps;
};

std::vector<Broken> brokenCubics() {
    const double third = std::sqrt(3.0) / 6;
    const double fifth = std::sqrt(80.0);
    return {
        {{{465.24423, 107.11105},
          {475.50754, 107.11105},
          {475.50754, 107.11105},
          {475.50754, 107.11105}},
         {1}},
        {{{0, -0.01}, {128, 128.001}, {128, -0.01}, {0, 128.001}}, {0.5}},
        {{{0, 0}, {0, -10}, {0, -10}, {0, 10}}, {1 / (1 + std::sqrt(2.0))}},
        {{{10, 0}, {0, 0}, {20, 0}, {10, 0}}, {0.5 - third, 0.5 + third}},
        {{{39, -39}, {40, -40}, {40, -40}, {0, 0}}, {1 / (1 + std::sqrt(40.0))}},
        {{{40, 40}, {0, 0}, {200, 200}, {0, 0}}, {(12 - fifth) / 32, (12 + fifth) / 32}},
        {{{0, 0}, {1e-2, 0}, {-1e-2, 0}, {0, 0}}, {0.5 - third, 0.5 + third}},
        {{{400.75, 100.05}, {400.75, 100.05}, {100.05, 300.95}, {100.05, 300.95}}, {0, 1}},
        {{{10, 0}, {0, 0}, {10, 0}, {10, 0}}, {1.0 / 3, 1}},
    };
}

TEST(Cusps, ofCubicsThatBrokeStrokers) {
    for (const auto& [points, wanted] : brokenCubics()) {
        expectSpots(cusps(pieceOf(points)), wanted, 1e-8, testing::PrintToString(points[1]));
        // Moved and turned the standstills are the same, but for rounding.
        std::vector<Point> moved;
        for (const Point& p : points) {
            moved.push_back({731 + 0.6 * p[0] - 0.8 * p[1], 55 + 0.8 * p[0] + 0.6 * p[1]});
        }
        expectSpots(cusps(pieceOf(moved)), wanted, 1e-6, testing::PrintToString(moved[1]));
    }
}

TEST(Inflections, straightCurvesHaveNone) {
    for (const auto& [points, wanted] : brokenCubics()) {
        const bool bends = points[0] == Point{0, -0.01}; // the only one that is not straight
        if (!bends) {
            EXPECT_TRUE(inflections(pieceOf(points)).empty()) << testing::PrintToString(points[0]);
            EXPECT_TRUE(vertices(pieceOf(points)).empty()) << testing::PrintToString(points[0]);
        }
    }
}

TEST(Cusps, ofTheSemicubicalParabola) {
    // (t^2, t^3) stands still at t = 0, and bends to the same side before and after.
    const Pieces cusp = cubicOf({0, 0, 1, 0}, {0, 0, 0, 1}, -0.7, 2);
    expectSpots(cusps(cusp), {0.7 / 2.7}, 1e-12, "cusp");
    EXPECT_TRUE(inflections(cusp).empty());
    // A hair beside it: a loop or a wave, but no cusp. The speed there is 1e-6 of the largest.
    EXPECT_TRUE(cusps(cubicOf({0, 0, 1, 0}, {0, 1e-4, 0, 1}, -0.7, 2)).empty());
    EXPECT_TRUE(cusps(cubicOf({0, 0, 1, 0}, {0, -1e-4, 0, 1}, -0.7, 2)).empty());
}

TEST(Cusps, inSpaceAndOnRationalPieces) {
    expectSpots(cusps(pieceOf({{5, 5, 5}, {6, 7, 8}, {6, 7, 8}, {5, 5, 5}})), {0.5}, 1e-9, "back");
    // A weight moves the standstill of a line that runs back: x = 1 + 2u(1-u)w / (...) is
    // symmetric, so at the middle whatever w is.
    expectSpots(cusps(pieceOf({{5, 5}, {6, 7}, {5, 5}}, {1, 3, 1})), {0.5}, 1e-9, "rational");
}

TEST(Cusps, atJointsOnceAndNotOnPoints) {
    const std::vector<Point> doubled = {{1, 2}, {2, 4}, {3, 5}, {3, 5}, {3, 5}, {4, 4}, {6, 2}};
    expectSpots(cusps(chainOf(3, doubled)), {1}, 0, "handles on the joint");
    EXPECT_TRUE(cusps(pieceOf({{3, 4}, {3, 4}, {3, 4}})).empty());
    EXPECT_TRUE(cusps(chainOf(1, {{3, 4}, {3, 4}, {5, 9}})).empty());
    EXPECT_TRUE(cusps(Pieces()).empty());
}

TEST(Vertices, ofAParabolaAndACircle) {
    // The vertex of y = x^2 at x = 0, for x from -1 to 3.
    expectSpots(vertices(pieceOf({{99, 51}, {101, 47}, {103, 59}})), {0.25}, 1e-12, "parabola");
    EXPECT_TRUE(vertices(pieceOf({{25, 30}, {25, 35}, {20, 35}}, {1, std::sqrt(0.5), 1})).empty());
    EXPECT_TRUE(vertices(Pieces()).empty());
    // A quarter of an ellipse, drawn from 45 degrees before its vertex to 45 degrees after.
    const double r = std::sqrt(0.5);
    expectSpots(vertices(pieceOf({{20 + 4 * r, 30 - r}, {20 + 8 * r, 30}, {20 + 4 * r, 30 + r}},
                                 {1, r, 1})),
                {0.5}, 1e-12, "ellipse");
}

TEST(Turning, sizeDoesNotMatterNorOtherDimensions) {
    for (const double size : {1e300, 1e150, 1e-150, 1e-300}) {
        const auto s = [&](double x, double y) { return Point{size * x, size * y}; };
        const Pieces wave = pieceOf({s(0, 0), s(1, 2), s(2, -2), s(3, 0)});
        expectSpots(inflections(wave), {0.5}, 1e-12, "wave");
        EXPECT_TRUE(cusps(wave).empty()) << size;
        const Pieces cusp = pieceOf({s(0, 0), s(1, 1), s(0, 1), s(1, 0)});
        expectSpots(cusps(cusp), {0.5}, 1e-7, "cusp of size " + std::to_string(size));
        vertices(wave);
    }
    EXPECT_TRUE(inflections(Pieces()).empty());
    EXPECT_TRUE(inflections(pieceOf({{1, 2, 3}, {4, 5, 7}, {1, 1, 1}, {0, 3, 3}})).empty());
}

} // namespace
} // namespace splineloft
