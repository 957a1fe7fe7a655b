#include "core/spline/shape/osculating.h"

#include "tests/property/random_pieces.h"

#include <cmath>

namespace splineloft {
namespace {

using namespace testing_curves;

TEST(OsculatingCircle, ofAParabola) {
    // y = 50 + (x - 100)^2 from 99 to 103. Its evolute is known: at x = 100 + t the center is
    // (100 - 4 t^3, 50 + 3 t^2 + 1/2), the radius (1 + 4 t^2)^(3/2) / 2.
    const Pieces parabola = pieceOf({{99, 51}, {101, 47}, {103, 59}});
    for (const double t : {-1.0, -0.3, 0.0, 1.0, 2.0, 3.0}) {
        const auto circle = osculatingCircle(parabola, {0, (t + 1) / 4});
        ASSERT_TRUE(circle) << t;
        EXPECT_NEAR(circle->radius, 0.5 * std::pow(1 + 4 * t * t, 1.5), 1e-10) << t;
        expectNear(circle->center, {100 - 4 * t * t * t, 50.5 + 3 * t * t}, 1e-9, "center");
    }
}

TEST(OsculatingCircle, ofACircleIsTheCircle) {
    const Pieces arc = pieceOf({{25, 30}, {25, 35}, {20, 35}}, {2, 2 * std::sqrt(0.5), 2});
    for (const double u : {0.0, 0.2, 0.9, 1.0}) {
        const auto circle = osculatingCircle(arc, {0, u});
        ASSERT_TRUE(circle);
        EXPECT_NEAR(circle->radius, 5, 1e-12);
        expectNear(circle->center, {20, 30}, 1e-12, "center");
    }
}

TEST(OsculatingCircle, ofASpaceCubic) {
    // (t, t^2, t^3) moved: at t = 0 the circle lies in the plane of the parabola.
    const auto circle = osculatingCircle(
        pieceOf({{7, 8, 9}, {7 + 1 / 3.0, 8, 9}, {7 + 2 / 3.0, 8 + 1 / 3.0, 9}, {8, 9, 10}}),
        {0, 0});
    ASSERT_TRUE(circle);
    expectNear(circle->center, {7, 8.5, 9}, 1e-12, "center");
    expectNear(circle->normal, {0, 1, 0}, 1e-12, "normal");
}

TEST(OsculatingCircle, nothingOfLinesPointsAndStandstills) {
    const Pieces line = pieceOf({{1000.1, 7}, {1000.2, 7.3}, {1000.3, 7.6}, {1000.4, 7.9}});
    EXPECT_FALSE(osculatingCircle(line, {0, 0.3})) << "rounding is no curvature";
    EXPECT_FALSE(osculatingCircle(pieceOf({{3, 4}, {3, 4}, {3, 4}}), {0, 0.5}));
    EXPECT_FALSE(osculatingCircle(pieceOf({{3, 4}, {3, 4}, {5, 9}, {6, 4}}), {0, 0}));
    EXPECT_FALSE(osculatingCircle(pieceOf({{3}, {4}, {9}}), {0, 0.5})) << "one dimension";
    EXPECT_FALSE(osculatingCircle(Pieces(), {}));
    EXPECT_FALSE(osculatingCircle(line, {5, 0.5}));
}

TEST(OsculatingCircle, ofHugeAndTinyCurves) {
    for (const double size : {1e300, 1e-290}) {
        const auto circle =
            osculatingCircle(pieceOf({{0, 0}, {size, 0}, {2 * size, 2 * size}}), {0, 0});
        ASSERT_TRUE(circle) << size;
        EXPECT_NEAR(circle->radius / size, 1, 1e-14) << size; // speed^2 / turning = 4 / 4
    }
    EXPECT_FALSE(osculatingCircle(pieceOf({{0, 0}, {1e308, 0}, {2e307, 1e293}}), {0, 1}))
        << "too far away";
}

} // namespace
} // namespace splineloft
