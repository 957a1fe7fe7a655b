// Conversion, extrema and zeros: the curve stays the same curve, to rounding.
#include "core/spline/algebra/roots.h"
#include "core/spline/catalog.h"
#include "core/spline/change/convert.h"
#include "core/spline/measure/bounds.h"
#include "tests/property/random_curves.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace splineloft {
namespace {

using namespace testing_curves;

/// Both curves at 9 values of u on every piece.
void expectSame(const Curve& one, const Curve& other, double tolerance, const std::string& what) {
    const Pieces a = piecesOf(one);
    const Pieces b = piecesOf(other);
    ASSERT_EQ(a.size(), b.size()) << what;
    for (std::size_t i = 0; i < a.size(); ++i) {
        for (int k = 0; k <= 8; ++k) {
            expectNear(b.position({i, k / 8.0}), a.position({i, k / 8.0}), tolerance,
                       what + ", segment " + std::to_string(i));
        }
    }
}

class Convert : public testing::TestWithParam<std::string> {};

TEST_P(Convert, toBezierSplineKeepsTheCurve) {
    forEveryForm(GetParam(), 5, [](const Curve& curve) {
        const Pieces pieces = piecesOf(curve);
        const auto result = converted(curve, "bezier-spline");
        if (pieces.empty() || (pieces.degree() > 3)) {
            EXPECT_TRUE(std::holds_alternative<Problem>(result));
            return;
        }
        const auto& spline = std::get<Curve>(result);
        EXPECT_FALSE(problemOf(spline));
        expectSame(curve, spline, 16 * roundingOf(curve, blendsOf(curve)), curve.family);
    });
}

TEST_P(Convert, toHermiteAndBackIsTheSameOrSaysWhyNot) {
    forEveryForm(GetParam(), 5, [](const Curve& curve) {
        const auto result = converted(curve, "hermite");
        if (const auto* problem = std::get_if<Problem>(&result)) {
            EXPECT_FALSE(problem->what.empty() || problem->remedy.empty());
            return;
        }
        const auto& hermite = std::get<Curve>(result);
        EXPECT_FALSE(problemOf(hermite));
        expectSame(curve, hermite, 64 * roundingOf(curve, blendsOf(curve)), curve.family);
    });
}

INSTANTIATE_TEST_SUITE_P(Families, Convert, testing::ValuesIn(familyIds()), testNameOf);

TEST(Convert, refusesWithAReason) {
    Curve curve;
    curve.family = "b-spline";
    curve.parameters["degree"] = 5;
    curve.points = {{0, 1}, {2, 3}, {4, 0}, {5, 5}, {6, 1}, {8, 2}, {9, 9}};
    const auto result = converted(curve, "bezier-spline");
    ASSERT_TRUE(std::holds_alternative<Problem>(result));
    EXPECT_NE(std::get<Problem>(result).what.find("degree 5"), std::string::npos);
    EXPECT_TRUE(std::holds_alternative<Problem>(converted(curve, "duff")));
    EXPECT_TRUE(std::holds_alternative<Problem>(converted(curve, "bezier")));
}

TEST(Convert, saysWhereItWouldDifferAndWhatWouldDo) {
    Curve curve;
    curve.family = "bezier-spline";
    curve.ends = Ends::none;
    curve.points = {{11, 3}, {12, 5}, {14, 6}, {17, 7}, {19, 5}, {23, 4}, {25, 9}};
    const auto result = converted(curve, "duff");
    ASSERT_TRUE(std::holds_alternative<Problem>(result));
    const auto& problem = std::get<Problem>(result);
    EXPECT_NE(problem.what.find("segment"), std::string::npos) << problem.what;
    EXPECT_NE(problem.what.find("would differ by"), std::string::npos) << problem.what;
    EXPECT_EQ(problem.remedy.find("b-spline"), 0U) << problem.remedy; // it is a Bézier spline
    EXPECT_TRUE(std::holds_alternative<Curve>(converted(curve, "b-spline")));
    const auto unknown = converted(curve, "kappa");
    EXPECT_NE(std::get<Problem>(unknown).what.find("kappa"), std::string::npos);
    curve.ends = Ends::clamped;
    EXPECT_EQ(std::get<Problem>(converted(curve, "duff")).place, "/ends");
}

TEST(Convert, bSplinesKeepTheParameterOthersTheirPlaceOnThePiece) {
    Curve curve;
    curve.family = "catmull-rom";
    curve.parameters["alpha"] = 0.5;
    curve.points = {{11, 3}, {14, 8}, {19, 4}, {23, 9}, {30, 2}};
    const auto kept = [&](const std::string& family) {
        const auto result = converted(curve, family);
        return differenceOf(piecesOf(curve), piecesOf(std::get<Curve>(result)))->sameParameter;
    };
    EXPECT_TRUE(kept("b-spline"));
    EXPECT_TRUE(kept("nurbs"));
    EXPECT_FALSE(kept("bezier-spline"));
    // Through Bézier points the intervals are lost, but the tangents still tell alpha.
    const auto bezier = std::get<Curve>(converted(curve, "bezier-spline"));
    const auto back = std::get<Curve>(converted(bezier, "catmull-rom"));
    EXPECT_EQ(back.parameters.at("alpha"), 0.5);
    EXPECT_EQ(back.points.size(), curve.points.size());
    EXPECT_EQ(back.ends, Ends::doubled);
}

TEST(Convert, aCircleIsNurbsOnly) {
    Curve curve;
    curve.family = "nurbs";
    curve.ends = Ends::none;
    curve.parameters["degree"] = 2;
    curve.points = {{9, 4}, {9, 6}, {7, 6}, {5, 6}, {5, 4}, {5, 2}, {7, 2}, {9, 2}, {9, 4}};
    curve.weights = {1, std::sqrt(0.5), 1, std::sqrt(0.5), 1, std::sqrt(0.5), 1, std::sqrt(0.5), 1};
    curve.knots = {0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4};
    for (const auto& family : familyIds()) {
        if (family != "nurbs") {
            const auto result = converted(curve, family);
            ASSERT_TRUE(std::holds_alternative<Problem>(result)) << family;
            EXPECT_NE(std::get<Problem>(result).what.find("rational"), std::string::npos);
        }
    }
    std::ranges::fill(curve.weights, 3.0); // which weigh nothing together
    expectSame(curve, std::get<Curve>(converted(curve, "bezier-spline")), 1e-14, "equal weights");
}

TEST(Elevated, degreeFromTwoToSevenIsTheSamePiece) {
    Curve curve;
    curve.family = "bezier";
    curve.ends = Ends::none;
    curve.points = {{101, 7}, {103.5, 11}, {107, 6}};
    const Pieces pieces = piecesOf(curve);
    Curve high = curve;
    high.points = Points(2);
    for (const auto& point : elevated(pieces[0], 7)) {
        high.points.append(point);
    }
    EXPECT_EQ(high.points.size(), 8U);
    expectSame(curve, high, 1e-12, "elevated");
}

TEST(Roots, ofKnownPolynomials) {
    // (u - 1/4)(u - 3/4): power form 3/16 - u + u^2.
    const auto two = rootsOf(std::vector{3.0 / 16, 3.0 / 16 - 0.5, 3.0 / 16});
    ASSERT_EQ(two.size(), 2U);
    EXPECT_NEAR(two[0], 0.25, 1e-15);
    EXPECT_NEAR(two[1], 0.75, 1e-15);
    EXPECT_EQ(rootsOf(std::vector{0.0, 1.0}), std::vector{0.0});
    EXPECT_EQ(rootsOf(std::vector{-1.0, 0.0}), std::vector{1.0});
    EXPECT_TRUE(rootsOf(std::vector{0.0, 0.0, 0.0}).empty());
    EXPECT_TRUE(rootsOf(std::vector{1.0, 2.0, 0.5}).empty());
    EXPECT_TRUE(rootsOf(std::vector{5.0}).empty());
    EXPECT_NEAR(rootsOf(std::vector{1e300, -1e300}).front(), 0.5, 1e-15);
    EXPECT_NEAR(rootsOf(std::vector{1e-300, -1e-300}).front(), 0.5, 1e-15);
}

class Bounds : public testing::TestWithParam<std::string> {};

TEST_P(Bounds, areTouchedAndNeverLeft) {
    forEveryForm(GetParam(), 5, [](const Curve& curve) {
        const Pieces pieces = piecesOf(curve);
        const auto box = bounds(pieces);
        ASSERT_EQ(box.has_value(), !pieces.empty());
        if (!box) {
            return;
        }
        const double tolerance = 64 * roundingOf(curve, blendsOf(curve));
        Box seen{pieces.position({0, 0}), pieces.position({0, 0})};
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            for (int k = 0; k <= 200; ++k) {
                const Point p = pieces.position({i, k / 200.0});
                for (int c = 0; c < p.dimension(); ++c) {
                    EXPECT_GE(p[c], box->low[c] - tolerance) << curve.family;
                    EXPECT_LE(p[c], box->high[c] + tolerance) << curve.family;
                    seen.low[c] = std::min(seen.low[c], p[c]);
                    seen.high[c] = std::max(seen.high[c], p[c]);
                }
            }
        }
        // 200 steps a piece come within (1/200)^2 / 8 of the second derivative of every extremum.
        const auto hull = hullBox(pieces);
        const double near =
            distance(hull->low, hull->high) * pieces.degree() * pieces.degree() * 4 / 320000;
        for (int c = 0; c < pieces.dimension(); ++c) {
            EXPECT_NEAR(box->low[c], seen.low[c], near + tolerance) << curve.family;
            EXPECT_NEAR(box->high[c], seen.high[c], near + tolerance) << curve.family;
        }
    });
}

INSTANTIATE_TEST_SUITE_P(Families, Bounds, testing::ValuesIn(familyIds()), testNameOf);

/// Two numbers at each joint must give three; there always are some, those of the curve itself.
TEST(ConvertOneCoordinate, findsValuesAtEachPointForEveryKochanekBartelsSpline) {
    for (std::uint64_t seed = 0; seed < 600; ++seed) {
        Dice dice(seed);
        const Ends ends = std::array{Ends::open, Ends::doubled, Ends::reflected}.at(seed % 3);
        Curve curve = emptyCurve({"kochanek-bartels", false, ends}, 1);
        for (int i = 0; i < 5; ++i) {
            curve.points.append(Point{dice.between(-10, 10)});
        }
        for (const char* key : {"tension", "continuity", "bias"}) {
            for (int i = 0; i < 5; ++i) {
                curve.local[key].push_back(dice.between(-1, 1));
            }
        }
        const auto spline = std::get<Curve>(converted(curve, "bezier-spline"));
        const auto back = converted(spline, "kochanek-bartels");
        const auto* found = std::get_if<Curve>(&back);
        ASSERT_NE(found, nullptr) << "seed " << seed << ": " << std::get<Problem>(back).what;
        expectSame(spline, *found, 1e-11, "seed " + std::to_string(seed));
    }
}

} // namespace
} // namespace splineloft
