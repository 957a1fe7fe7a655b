// The program in the appendix of Smith's memo of 1983, as a few lines on our core, and without its
// faults: it ran past the end of its points and of its result, left out the last point that it
// promised, let three points and no grain pass, and its test of tension and bias guarded nothing.
#include "core/spline/curve.h"
#include "core/spline/measure/sample.h"
#include "core/spline/problem.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

namespace splineloft {
namespace {

enum class Type { beta, cardinal };

/// `grain` line segments from point to point along a spline that begins near the second point and
/// ends near the last but one: (n - 3) * grain + 1 points, both ends included. Nothing for fewer
/// than four points, for no grain, and for parameters that the family does not have.
std::optional<Points> cubicSpline(const Points& points, std::size_t grain, Type type,
                                  double tension, double bias) {
    Curve curve;
    curve.family = type == Type::beta ? "beta" : "cardinal";
    curve.parameters["tension"] = tension;
    if (type == Type::beta) {
        curve.parameters["bias"] = bias;
    }
    curve.ends = Ends::open;
    curve.coordinates = {"x", "y", "z"};
    curve.points = points;
    if (grain < 1 || points.size() < fewestPoints(curve) || problemOf(curve)) {
        return std::nullopt;
    }
    const Pieces pieces = piecesOf(curve);
    Points along(points.dimension());
    for (const auto& spot : spreadPerPiece(pieces, grain)) {
        along.append(pieces.position(spot));
    }
    return along;
}

using Matrix = std::array<std::array<double, 4>, 4>;

/// The memo's matrix of the cardinal spline, rows from u^3 to 1.
Matrix cardinalMatrix(double a) {
    return {{{-a, 2 - a, a - 2, a}, {2 * a, a - 3, 3 - 2 * a, -a}, {-a, 0, a, 0}, {0, 1, 0, 0}}};
}

/// The memo's matrix of the beta-spline, of bias b1 and tension b2.
Matrix betaMatrix(double b1, double b2) {
    const double square = b1 * b1;
    const double cube = b1 * square;
    const double delta = b2 + 2 * cube + 4 * square + 4 * b1 + 2;
    Matrix m = {{{-2 * cube, 2 * (b2 + cube + square + b1), -2 * (b2 + square + b1 + 1), 2},
                 {6 * cube, -3 * (b2 + 2 * cube + 2 * square), 3 * (b2 + 2 * square), 0},
                 {-6 * cube, 6 * (cube - b1), 6 * b1, 0},
                 {2 * cube, b2 + 4 * (square + b1), 2, 0}}};
    for (auto& row : m) {
        for (double& entry : row) {
            entry /= delta;
        }
    }
    return m;
}

/// One coordinate of a piece that begins after the first of four points.
double onPiece(const Matrix& m, const Points& points, std::size_t first, int coordinate, double u) {
    double value = 0;
    for (const auto& row : m) { // Horner
        double coefficient = 0;
        for (std::size_t k = 0; k < 4; ++k) {
            coefficient += row[k] * points[first + k][static_cast<std::size_t>(coordinate)];
        }
        value = value * u + coefficient;
    }
    return value;
}

const Points path = {{-3.5, 2, 0.25}, {-1, 4.5, 1},      {2.25, -1.5, 7}, {4, 1, -2},
                     {5.75, 3, 0.5},  {6.5, -2.25, 3.5}, {9, 0.125, -1}};

void expectMatrix(const Matrix& m, const Points& along, std::size_t grain) {
    const auto pieces = path.size() - 3;
    ASSERT_EQ(along.size(), pieces * grain + 1);
    for (std::size_t i = 0; i < along.size(); ++i) {
        const auto piece = std::min(i / grain, pieces - 1);
        const double u = static_cast<double>(i - piece * grain) / static_cast<double>(grain);
        for (int c = 0; c < 3; ++c) {
            EXPECT_NEAR(along.at(i)[c], onPiece(m, path, piece, c, u), 1e-13 * 9)
                << "point " << i << ", coordinate " << c;
        }
    }
}

TEST(Memo, givesThePointsOfItsMatrices) {
    for (const std::size_t grain : {1u, 2u, 7u, 256u, 1000u}) {
        for (const double a : {0.0, 0.5, 1.0, 2.5}) {
            const auto along = cubicSpline(path, grain, Type::cardinal, a, 0);
            ASSERT_TRUE(along);
            expectMatrix(cardinalMatrix(a), *along, grain);
        }
        for (const auto& [bias, tension] :
             {std::pair{1.0, 0.0}, {1.0, 10.0}, {2.5, 0.0}, {0.25, 4.0}}) {
            const auto along = cubicSpline(path, grain, Type::beta, tension, bias);
            ASSERT_TRUE(along);
            expectMatrix(betaMatrix(bias, tension), *along, grain);
        }
    }
}

TEST(Memo, includesTheLastPoint) {
    for (const std::size_t grain : {1u, 3u, 10u}) {
        const auto along = cubicSpline(path, grain, Type::cardinal, 0.5, 0);
        ASSERT_TRUE(along);
        EXPECT_EQ(along->at(0), path.at(1));
        EXPECT_EQ(along->at(along->size() - 1), path.at(path.size() - 2));
        for (std::size_t i = 0; i + 3 < path.size(); ++i) {
            EXPECT_EQ(along->at(i * grain), path.at(i + 1)) << "a cardinal spline goes through it";
        }
    }
}

TEST(Memo, takesFourPointsAndNoFewer) {
    Points few = {{1, 2, 3}, {2, 4, 3}, {5, 4, 1}};
    EXPECT_FALSE(cubicSpline(few, 10, Type::cardinal, 0.5, 0)) << "three points have no piece";
    EXPECT_FALSE(cubicSpline(Points(3), 10, Type::beta, 0, 1));
    few.append({7, 7, 7});
    const auto along = cubicSpline(few, 10, Type::cardinal, 0.5, 0);
    ASSERT_TRUE(along);
    EXPECT_EQ(along->size(), 11u);
}

TEST(Memo, refusesWhatHasNoMeaning) {
    EXPECT_FALSE(cubicSpline(path, 0, Type::cardinal, 0.5, 0)) << "no grain";
    EXPECT_FALSE(cubicSpline(path, 4, Type::beta, -12, 1)) << "delta is 0";
    EXPECT_FALSE(cubicSpline(path, 4, Type::beta, 0, 0)) << "the test that guarded nothing";
    EXPECT_FALSE(cubicSpline(path, 4, Type::beta, 0, -1));
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(cubicSpline(path, 4, Type::beta, nan, 1));
    EXPECT_FALSE(cubicSpline(path, 4, Type::cardinal, nan, 1));
}

TEST(Memo, hasNoLimitOfPoints) {
    constexpr std::size_t grain = 5000; // the memo's result held 4096 points, its grain was 256
    const auto along = cubicSpline(path, grain, Type::beta, 0, 1);
    ASSERT_TRUE(along);
    EXPECT_EQ(along->size(), 4 * grain + 1);
}

TEST(Memo, duffsTensionIsOneOfBarskys) {
    for (const double a : {0.125, 0.5, 1.0}) {
        const auto beta = cubicSpline(path, 5, Type::beta, 12 * (1 - a) / a, 1);
        ASSERT_TRUE(beta);
        Curve duff;
        duff.family = "duff";
        duff.parameters["tension"] = a;
        duff.ends = Ends::open;
        duff.coordinates = {"x", "y", "z"};
        duff.points = path;
        const Pieces pieces = piecesOf(duff);
        const auto spots = spreadPerPiece(pieces, 5);
        for (std::size_t i = 0; i < spots.size(); ++i) {
            EXPECT_LT(distance(pieces.position(spots[i]), beta->at(i)), 1e-13 * 9) << a;
        }
    }
}

TEST(Memo, aCycleIsTheLastPointInFrontAndTheFirstTwoAtTheEnd) {
    Points around(3);
    around.append(path.at(path.size() - 1));
    for (std::size_t i = 0; i < path.size(); ++i) {
        around.append(path.at(i));
    }
    around.append(path.at(0));
    around.append(path.at(1));
    const auto along = cubicSpline(around, 6, Type::cardinal, 0.5, 0);
    ASSERT_TRUE(along);
    Curve closed;
    closed.coordinates = {"x", "y", "z"};
    closed.points = path;
    closed.closed = true;
    const Pieces pieces = piecesOf(closed);
    const auto spots = spreadPerPiece(pieces, 6);
    ASSERT_EQ(spots.size(), along->size());
    for (std::size_t i = 0; i < spots.size(); ++i) {
        EXPECT_LT(distance(pieces.position(spots[i]), along->at(i)), 1e-13 * 9) << i;
    }
}

TEST(Memo, multiplicityPullsAnApproximatingSplineToItsPoint) {
    const Point middle = path.at(3);
    double before = std::numeric_limits<double>::infinity();
    for (const int times : {1, 2, 3}) {
        Points repeated = path;
        for (int i = 1; i < times; ++i) {
            repeated.insert(3, middle);
        }
        const auto along = cubicSpline(repeated, 64, Type::beta, 0, 1);
        ASSERT_TRUE(along);
        double nearest = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < along->size(); ++i) {
            nearest = std::min(nearest, distance(along->at(i), middle));
        }
        EXPECT_LT(nearest, before) << times << " times";
        before = nearest;
    }
    EXPECT_LT(before, 1e-14) << "three times over it is reached";
}

} // namespace
} // namespace splineloft
