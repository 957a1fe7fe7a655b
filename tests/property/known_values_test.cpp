// Values that stand in print elsewhere, each with its source; and lengths with a closed form.
#include "core/spline/measure/length.h"
#include "tests/property/random_curves.h"

#include <cmath>
#include <numbers>

namespace splineloft::testing_curves {
namespace {

Curve bSpline(int degree, const Points& points, std::vector<double> knots) {
    Curve curve = emptyCurve({"b-spline", false, Ends::none}, points.dimension());
    curve.points = points;
    curve.parameters["degree"] = degree;
    curve.knots = std::move(knots);
    return curve;
}

Point at(const Pieces& pieces, double t) {
    return pieces.position(pieces.knots().locate(t));
}

// SciPy 1.x reference, scipy.interpolate.BSpline, first example: spl(2.5) is 1.375.
TEST(Known, bSplineOfTheScipyReference) {
    const Pieces pieces = piecesOf(bSpline(2, {{-1}, {2}, {0}, {-1}}, {0, 1, 2, 3, 4, 5, 6}));
    EXPECT_EQ(pieces.knots().start(), 2);
    EXPECT_EQ(pieces.knots().end(), 4);
    EXPECT_DOUBLE_EQ(at(pieces, 2.5)[0], 1.375);
}

// At its knots the uniform B-spline of degree d has the Eulerian numbers (OEIS A008292) over d!.
TEST(Known, uniformBasisHasEulerianNumbers) {
    const std::vector<std::vector<double>> eulerian = {{1},
                                                       {1, 1},
                                                       {1, 4, 1},
                                                       {1, 11, 11, 1},
                                                       {1, 26, 66, 26, 1},
                                                       {1, 57, 302, 302, 57, 1},
                                                       {1, 120, 1191, 2416, 1191, 120, 1}};
    double factorial = 1;
    for (int degree = 1; degree <= 7; ++degree) {
        factorial *= degree;
        Curve curve = emptyCurve({"b-spline", false, Ends::open}, 1);
        curve.parameters["degree"] = degree;
        Dice dice(1);
        rollPoints(curve, static_cast<std::size_t>(degree) + 1, {3}, 5, dice);
        const BlendPieces blends = blendsOf(curve);
        const Blend basis = blends.basis({0, 0});
        for (int i = 0; i < degree; ++i) {
            EXPECT_NEAR(
                basis.weight(static_cast<std::size_t>(i)),
                eulerian[static_cast<std::size_t>(degree - 1)][static_cast<std::size_t>(i)] /
                    factorial,
                1e-15)
                << "degree " << degree << ", control point " << i;
        }
    }
}

// Mitchell and Netravali 1988, their filter with B = C = 1/3: 1 - B/3 = 8/9 at the sample itself,
// B/6 = 1/18 at its neighbour, and 77/144 halfway.
TEST(Known, mitchellsFilter) {
    Curve curve = emptyCurve({"bc-spline", false, Ends::open}, 1);
    curve.points = {{2}, {3}, {5}, {7}};
    const BlendPieces blends = blendsOf(curve);
    const Blend start = blends.basis({0, 0});
    EXPECT_NEAR(start.weight(1), 8.0 / 9, 1e-15);
    EXPECT_NEAR(start.weight(0), 1.0 / 18, 1e-15);
    const Blend half = blends.basis({0, 0.5});
    EXPECT_NEAR(half.weight(1), 77.0 / 144, 1e-15);
    EXPECT_NEAR(half.weight(0), 0.5 - 77.0 / 144, 1e-15);
}

// Catmull-Rom halfway: (-1, 9, 9, -1) / 16, the four-point scheme of Dyn, Levin and Gregory 1987.
TEST(Known, fourPointScheme) {
    Curve curve = emptyCurve({"catmull-rom", false, Ends::open}, 1);
    curve.points = {{2}, {3}, {5}, {7}};
    curve.parameters["alpha"] = 0;
    const Blend half = blendsOf(curve).basis({0, 0.5});
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_NEAR(half.weight(i), (i == 0 || i == 3 ? -1 : 9) / 16.0, 1e-16) << i;
    }
}

// The parabola from (a, a^2) to (b, b^2): the integral of sqrt(1 + 4 x^2) is
// x/2 sqrt(1 + 4 x^2) + asinh(2x)/4 (any table of integrals).
TEST(Known, lengthOfTheParabola) {
    const auto antiderivative = [](double x) {
        return x / 2 * std::sqrt(1 + 4 * x * x) + std::asinh(2 * x) / 4;
    };
    Dice dice(11);
    for (int round = 0; round < 2000; ++round) {
        const double a = dice.between(-5, 5);
        const double b = a + dice.between(0.01, 7);
        Curve curve = emptyCurve({"bezier", false, Ends::none}, 2);
        curve.points = {{a, a * a}, {(a + b) / 2, a * b}, {b, b * b}};
        const double length = antiderivative(b) - antiderivative(a);
        EXPECT_NEAR(ArcLength(piecesOf(curve)).total(), length, 1e-13 * length + 1e-14)
            << a << " to " << b;
    }
}

// The semicubical parabola (t^2, t^3), the first curve ever rectified (Neile 1657): its length from
// the cusp to t is ((4 + 9 t^2)^(3/2) - 8) / 27.
TEST(Known, lengthFromTheCuspOfNeilesParabola) {
    for (const double t : {0.125, 0.5, 1.0, 3.0}) {
        // Bernstein coefficients of (s t)^2 and (s t)^3 for s from 0 to 1, moved off the origin.
        Curve curve = emptyCurve({"bezier", false, Ends::none}, 2);
        curve.points = {{7, -2}, {7, -2}, {7 + t * t / 3, -2}, {7 + t * t, -2 + t * t * t}};
        const double length = (std::pow(4 + 9 * t * t, 1.5) - 8) / 27;
        EXPECT_NEAR(ArcLength(piecesOf(curve)).total(), length, 1e-13 * (10 + length)) << t;
    }
}

/// A circle in nine control points (Piegl and Tiller 1997, section 7.5).
Curve circle(double x, double y, double radius) {
    Curve curve = emptyCurve({"nurbs", false, Ends::none}, 2);
    const std::vector<Point> corners = {{1, 0},   {1, 1},  {0, 1},  {-1, 1}, {-1, 0},
                                        {-1, -1}, {0, -1}, {1, -1}, {1, 0}};
    for (const auto& corner : corners) {
        curve.points.append(Point({x, y}) + radius * corner);
        curve.weights.push_back(curve.weights.size() % 2 == 0 ? 1 : std::numbers::sqrt2 / 2);
    }
    curve.parameters["degree"] = 2;
    curve.knots = {0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4};
    return curve;
}

TEST(Known, rationalCircleIsOne) {
    Dice dice(5);
    for (int round = 0; round < 300; ++round) {
        const Point center = dice.pointOnGrid(2, 9);
        const double radius = dice.between(0.5, 20);
        const Pieces pieces = piecesOf(circle(center[0], center[1], radius));
        ASSERT_EQ(pieces.size(), 4u);
        for (int k = 0; k <= 64; ++k) {
            const Jet jet = pieces.jet(pieces.knots().locate(k / 16.0));
            EXPECT_NEAR(distance(jet.position, center), radius, 1e-14 * (radius + 10));
            EXPECT_NEAR(jet.curvature.value_or(0) * radius, 1, 1e-12) << "k " << k;
        }
        const double around = 2 * std::numbers::pi * radius;
        EXPECT_NEAR(ArcLength(pieces).total(), around, 1e-13 * around);
    }
}

} // namespace
} // namespace splineloft::testing_curves
