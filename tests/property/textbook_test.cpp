// The formulas as the sources print them, against our Bézier blends.
#include "core/spline/algebra/scale.h"
#include "tests/property/random_curves.h"

#include <array>
#include <cmath>
#include <limits>

namespace splineloft::testing_curves {
namespace {

/// A 4 x 4 matrix row by row as printed: rows belong to u^3, u^2, u, 1, columns to the points.
using Matrix = std::array<std::array<double, 4>, 4>;

Matrix operator*(double factor, Matrix m) {
    for (auto& row : m) {
        for (auto& entry : row) {
            entry *= factor;
        }
    }
    return m;
}

/// Weight of point `column` at u: [u^3 u^2 u 1] times that column.
double weightAt(const Matrix& m, std::size_t column, double u) {
    return ((m[0][column] * u + m[1][column]) * u + m[2][column]) * u + m[3][column];
}

// clang-format off

/// Smith 1983, "The Classic Interpolating Spline".
Matrix catmullRomMatrix() {
    return 0.5 * Matrix{{{-1,  3, -3,  1},
                         { 2, -5,  4, -1},
                         {-1,  0,  1,  0},
                         { 0,  2,  0,  0}}};
}

/// Smith 1983, "The Cardinal Splines".
Matrix cardinalMatrix(double a) {
    return {{{ -a,   2 - a,  a - 2,     a},
             {2*a,   a - 3,  3 - 2*a,  -a},
             { -a,       0,  a,         0},
             {  0,       1,  0,         0}}};
}

/// Smith 1983, "The Classic Approximating Spline".
Matrix bSplineMatrix() {
    return (1.0 / 6) * Matrix{{{-1,  3, -3, 1},
                               { 3, -6,  3, 0},
                               {-3,  0,  3, 0},
                               { 1,  4,  1, 0}}};
}

/// Smith 1983, "Tensioned B-Splines".
Matrix duffMatrix(double a) {
    return (1.0 / 6) * Matrix{{{  -a,  12 - 9*a,   9*a - 12,  a},
                               { 3*a,  12*a - 18,  18 - 15*a, 0},
                               {-3*a,  0,          3*a,       0},
                               {   a,  6 - 2*a,    a,         0}}};
}

/// Smith 1983, "The Beta Splines".
Matrix betaMatrix(double b1, double b2) {
    const double b1_2 = b1 * b1;
    const double b1_3 = b1 * b1 * b1;
    const double delta = b2 + 2*b1_3 + 4*b1_2 + 4*b1 + 2;
    return (1 / delta) * Matrix{{{-2*b1_3,  2*(b2 + b1_3 + b1_2 + b1), -2*(b2 + b1_2 + b1 + 1), 2},
                                 { 6*b1_3, -3*(b2 + 2*b1_3 + 2*b1_2),   3*(b2 + 2*b1_2),        0},
                                 {-6*b1_3,  6*(b1_3 - b1),              6*b1,                   0},
                                 { 2*b1_3,  b2 + 4*(b1_2 + b1),         2,                      0}}};
}

// clang-format on

/// The blends of the one piece that four points make when the ends are open.
BlendPieces fourPoints(const std::string& family, std::map<std::string, double> parameters) {
    Curve curve = emptyCurve({family, false, Ends::open}, 1);
    curve.parameters = std::move(parameters);
    curve.points = {{3}, {5}, {4}, {9}};
    return blendsOf(curve);
}

void expectMatrix(const BlendPieces& blends, const Matrix& matrix, const std::string& name) {
    ASSERT_EQ(blends.size(), 1u) << name;
    double largest = 1;
    for (const auto& row : matrix) {
        for (const double entry : row) {
            largest = std::max(largest, std::abs(entry));
        }
    }
    for (int k = 0; k <= 20; ++k) {
        const double u = k / 20.0;
        for (std::size_t point = 0; point < 4; ++point) {
            EXPECT_NEAR(blends.basis({0, u}).weight(point), weightAt(matrix, point, u),
                        32 * epsilon * largest)
                << name << ", point " << point << ", u " << u;
        }
    }
}

const std::vector<double> tensions = {0, 0.1, 0.25, 0.5, 0.75, 1, 1.7, -0.6};

TEST(Memo, matrixOfCatmullRom) {
    expectMatrix(fourPoints("cardinal", {{"tension", 0.5}}), catmullRomMatrix(), "cardinal 1/2");
    expectMatrix(fourPoints("catmull-rom", {{"alpha", 0}}), catmullRomMatrix(), "catmull-rom 0");
}

TEST(Memo, matrixOfTheCardinalSpline) {
    for (const double a : tensions) {
        expectMatrix(fourPoints("cardinal", {{"tension", a}}), cardinalMatrix(a),
                     "cardinal " + std::to_string(a));
    }
}

TEST(Memo, matrixOfTheBSpline) {
    expectMatrix(fourPoints("b-spline", {{"degree", 3}}), bSplineMatrix(), "b-spline");
    expectMatrix(fourPoints("duff", {{"tension", 1}}), bSplineMatrix(), "duff 1");
    expectMatrix(fourPoints("beta", {{"bias", 1}, {"tension", 0}}), bSplineMatrix(), "beta 1, 0");
}

TEST(Memo, matrixOfDuffsSpline) {
    for (const double a : {0.0, 0.1, 0.25, 0.5, 0.75, 1.0}) {
        expectMatrix(fourPoints("duff", {{"tension", a}}), duffMatrix(a),
                     "duff " + std::to_string(a));
    }
}

TEST(Memo, matrixOfTheBetaSpline) {
    for (const double b1 : {0.125, 0.5, 1.0, 1.7, 8.0}) {
        for (const double b2 : {0.0, 0.3, 4.0, 50.0}) {
            expectMatrix(fourPoints("beta", {{"bias", b1}, {"tension", b2}}), betaMatrix(b1, b2),
                         "beta " + std::to_string(b1) + ", " + std::to_string(b2));
        }
    }
}

TEST(Memo, duffIsABetaSplineOfTensionTwelveTimesOneMinusAOverA) {
    for (const double a : {0.1, 0.25, 0.5, 0.75, 1.0}) {
        expectMatrix(fourPoints("beta", {{"bias", 1}, {"tension", 12 * (1 - a) / a}}),
                     duffMatrix(a), "a " + std::to_string(a));
    }
}

TEST(Memo, basisOfTheCardinalSplineDipsBelowZeroAndThatOfTheBSplineDoesNot) {
    const auto cardinal = fourPoints("cardinal", {{"tension", 0.5}});
    EXPECT_NEAR(cardinal.basis({0, 1.0 / 3}).weight(0), -2.0 / 27, 4 * epsilon) << "deepest of all";
    EXPECT_NEAR(cardinal.basis({0, 2.0 / 3}).weight(3), -2.0 / 27, 4 * epsilon);
    const auto bSpline = fourPoints("b-spline", {});
    for (int k = 0; k <= 20; ++k) {
        const Blend basis = bSpline.basis({0, k / 20.0});
        for (const auto& share : basis.shares()) {
            EXPECT_GE(share.weight, 0) << "u " << k / 20.0;
        }
    }
}

TEST(HermiteIntroduction, fourFunctions) {
    Curve curve = emptyCurve({"hermite", false, Ends::none}, 1);
    curve.points = {{3}, {5}};
    curve.tangents = {{-2}, {7}};
    const BlendPieces blends = blendsOf(curve);
    for (int k = 0; k <= 20; ++k) {
        const double t = k / 20.0;
        const Blend basis = blends.basis({0, t});
        // Points first, then the tangents.
        EXPECT_NEAR(basis.weight(0), 2 * t * t * t - 3 * t * t + 1, 8 * epsilon) << t;
        EXPECT_NEAR(basis.weight(1), -2 * t * t * t + 3 * t * t, 8 * epsilon) << t;
        EXPECT_NEAR(basis.weight(2), t * t * t - 2 * t * t + t, 8 * epsilon) << t;
        EXPECT_NEAR(basis.weight(3), t * t * t - t * t, 8 * epsilon) << t;
    }
    const Pieces pieces = piecesOf(curve);
    expectNear(pieces.jet({0, 0}).first, {-2}, 8 * epsilon, "tangent at the start");
    expectNear(pieces.jet({0, 1}).first, {7}, 32 * epsilon, "tangent at the end");
}

TEST(Lecture, bernsteinFunctions) {
    for (int degree = 1; degree <= 12; ++degree) {
        Curve curve = emptyCurve({"bezier", false, Ends::none}, 1);
        for (int i = 0; i <= degree; ++i) {
            curve.points.append(Point{1.0 + i * i});
        }
        const BlendPieces blends = blendsOf(curve);
        for (const double u : {0.0, 0.1, 0.6, 1.0}) {
            double binomial = 1;
            for (int i = 0; i <= degree; ++i) {
                const double wanted = binomial * std::pow(u, i) * std::pow(1 - u, degree - i);
                EXPECT_NEAR(blends.basis({0, u}).weight(static_cast<std::size_t>(i)), wanted,
                            2 * degree * epsilon)
                    << "N " << degree << ", i " << i << ", u " << u;
                binomial = binomial * (degree - i) / (i + 1);
            }
        }
    }
}

TEST(Lecture, endTangentsOfBezierAreDegreeTimesTheEndLegs) {
    Curve curve = emptyCurve({"bezier", false, Ends::none}, 2);
    curve.points = {{101, 7}, {104, 12}, {110, 3}, {111, 9}, {95, 20}};
    const Pieces pieces = piecesOf(curve);
    EXPECT_EQ(pieces.jet({0, 0}).first, Point({12, 20}));
    EXPECT_EQ(pieces.jet({0, 1}).first, Point({-64, 44}));
}

} // namespace
} // namespace splineloft::testing_curves
