// Knots come in and degrees go up, and the curve stays the same curve.
#include "core/spline/catalog.h"
#include "core/spline/change/convert.h"
#include "core/spline/change/knots.h"
#include "core/spline/change/shape.h"
#include "tests/cases.h"
#include "tests/property/random_curves.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace splineloft {
namespace {

using namespace testing_curves;

/// Both curves at random parameter values t, and at the ends of their lines.
void expectSameByParameter(const Curve& one, const Curve& other, Dice& dice, double tolerance) {
    const Pieces a = piecesOf(one);
    const Pieces b = piecesOf(other);
    EXPECT_EQ(b.knots().start(), a.knots().start());
    EXPECT_EQ(b.knots().end(), a.knots().end());
    for (int k = 0; k < 12; ++k) {
        const double t = dice.between(a.knots().start(), a.knots().end());
        expectNear(b.position(b.knots().locate(t)), a.position(a.knots().locate(t)), tolerance,
                   wordsOf(other) + " at t = " + std::to_string(t));
    }
}

/// A B-spline, with weights now and then, with knots of any kind.
Curve rolled(const std::string& family, std::uint64_t seed) {
    const auto forms = formsOf(family);
    Dice dice(seed);
    Curve curve =
        randomCurve(forms[static_cast<std::size_t>(dice.whole(0, int(forms.size()) - 1))], seed);
    if (family == "nurbs") {
        for (std::size_t i = 0; i < curve.points.size(); ++i) {
            curve.weights.push_back(std::exp2(dice.between(-3, 3)));
        }
    }
    return curve;
}

double toleranceOf(const Curve& curve) {
    const double heaviest = curve.weights.empty() ? 1 : 64;
    return 64 * heaviest * roundingOf(curve, blendsOf(curve));
}

class Knots : public testing::TestWithParam<std::string> {};

TEST_P(Knots, writtenOutAreTheSameCurve) {
    for (std::uint64_t seed = 1; seed <= 500; ++seed) {
        const Curve curve = rolled(GetParam(), seed);
        SCOPED_TRACE(wordsOf(curve) + " seed " + std::to_string(seed));
        const auto result = withOwnKnots(curve);
        ASSERT_TRUE(std::holds_alternative<Curve>(result)) << std::get<Problem>(result).what;
        const auto& own = std::get<Curve>(result);
        EXPECT_FALSE(problemOf(own));
        const auto degree = static_cast<std::size_t>(parameterOf(own, "degree"));
        EXPECT_EQ(own.knots.size(), own.points.size() + (own.closed ? 1 : degree + 1));
        const auto difference = differenceOf(piecesOf(curve), piecesOf(own));
        ASSERT_TRUE(difference);
        EXPECT_LE(difference->most, toleranceOf(curve));
        EXPECT_TRUE(difference->sameParameter);
    }
}

TEST_P(Knots, oneMoreChangesNothing) {
    for (std::uint64_t seed = 1; seed <= casesOf(50'000); ++seed) {
        Dice dice(seed + 77);
        const Curve curve = rolled(GetParam(), seed);
        SCOPED_TRACE(wordsOf(curve) + " seed " + std::to_string(seed));
        const Pieces pieces = piecesOf(curve);
        const auto own = std::get<Curve>(withOwnKnots(curve));
        const auto joints = pieces.knots().knots();
        const double t = dice.oneIn(3) ? joints[static_cast<std::size_t>(
                                             dice.whole(0, static_cast<int>(joints.size()) - 1))]
                                       : dice.between(joints.front(), joints.back());
        const int times = dice.whole(1, 3);
        const auto result = withKnot(curve, t, times);
        if (const auto* problem = std::get_if<Problem>(&result)) {
            EXPECT_NE(problem->what.find("would have the knot"), std::string::npos)
                << problem->what;
            continue;
        }
        const auto& more = std::get<Curve>(result);
        EXPECT_FALSE(problemOf(more));
        EXPECT_EQ(more.points.size(), own.points.size() + static_cast<std::size_t>(times));
        EXPECT_EQ(more.knots.size(), own.knots.size() + static_cast<std::size_t>(times));
        expectSameByParameter(curve, more, dice, toleranceOf(curve));
        if (testing::Test::HasFailure()) {
            return;
        }
    }
}

TEST_P(Knots, untilEachStandsDegreeTimesAreTheBezierPoints) {
    for (std::uint64_t seed = 1; seed <= roundsOf(200); ++seed) {
        Curve curve = rolled(GetParam(), seed);
        SCOPED_TRACE(wordsOf(curve) + " seed " + std::to_string(seed));
        const Pieces pieces = piecesOf(curve);
        const int degree = pieces.degree();
        curve = std::get<Curve>(withOwnKnots(curve));
        for (std::size_t i = 0; i < pieces.size() + (curve.closed ? 0 : 1); ++i) {
            const double t = pieces.knots().knots()[i];
            while (std::ranges::count(curve.knots, t) < degree) {
                auto next = withKnot(curve, t);
                if (std::holds_alternative<Problem>(next)) {
                    break; // across the seam it stands there already
                }
                curve = std::get<Curve>(std::move(next));
            }
        }
        // The point whose knots are all at the start of a piece is its first Bézier point, ...
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            const double t = pieces.knots().knots()[i];
            const auto after = std::ranges::upper_bound(curve.knots, t) - curve.knots.begin();
            const auto lead = curve.closed ? (degree - 1) / 2 : degree;
            for (int k = 0; k <= degree; ++k) {
                auto index = after - 1 - lead + k;
                if (curve.closed) {
                    const auto n = static_cast<std::ptrdiff_t>(curve.points.size());
                    index = ((index % n) + n) % n;
                }
                expectNear(curve.points.at(static_cast<std::size_t>(index)),
                           pieces[i].bezierPoint(k), toleranceOf(curve),
                           "segment " + std::to_string(i) + ", point " + std::to_string(k));
            }
            if (testing::Test::HasFailure()) {
                return;
            }
        }
    }
}

TEST_P(Knots, oneDegreeMoreChangesNothing) {
    for (std::uint64_t seed = 1; seed <= casesOf(50'000); ++seed) {
        Dice dice(seed + 5);
        const Curve curve = rolled(GetParam(), seed);
        SCOPED_TRACE(wordsOf(curve) + " seed " + std::to_string(seed));
        const auto result = elevated(curve);
        ASSERT_TRUE(std::holds_alternative<Curve>(result)) << std::get<Problem>(result).what;
        const auto& high = std::get<Curve>(result);
        EXPECT_FALSE(problemOf(high));
        EXPECT_EQ(parameterOf(high, "degree"), parameterOf(curve, "degree") + 1);
        const auto difference = differenceOf(piecesOf(curve), piecesOf(high));
        ASSERT_TRUE(difference);
        // What the header promises: uneven knots of degree 7 need more than a few roundings.
        const double tolerance = conversion::toleranceOf(piecesOf(curve));
        EXPECT_LE(difference->most, tolerance);
        EXPECT_TRUE(difference->sameParameter);
        expectSameByParameter(curve, high, dice, tolerance);
        if (testing::Test::HasFailure()) {
            return;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Families, Knots, testing::Values("b-spline", "nurbs"), testNameOf);

TEST(Insertion, ofTheTextbook) {
    // Uniform cubic, a knot in the middle of its only piece: each leg is divided 5:1, 3:3 and 1:5.
    Curve curve;
    curve.family = "b-spline";
    curve.ends = Ends::open;
    curve.points = {{11, 3}, {17, 9}, {23, 9}, {29, 3}};
    const auto result = std::get<Curve>(withKnot(curve, 0.5));
    const Points wanted = {{11, 3}, {16, 8}, {20, 9}, {24, 8}, {29, 3}};
    ASSERT_EQ(result.points.size(), 5U);
    for (std::size_t i = 0; i < 5; ++i) {
        expectNear(result.points.at(i), wanted.at(i), 1e-14, std::to_string(i));
    }
    EXPECT_EQ(result.knots, (std::vector<double>{-3, -2, -1, 0, 0.5, 1, 2, 3, 4}));
}

TEST(Insertion, refusesWithAReason) {
    Curve curve;
    curve.family = "b-spline";
    curve.ends = Ends::clamped;
    curve.points = {{1, 2}, {3, 5}, {4, 4}, {7, 8}, {9, 1}};
    const auto refusal = [&](double t, int times = 1) {
        const auto result = withKnot(curve, t, times);
        EXPECT_TRUE(std::holds_alternative<Problem>(result)) << t;
        return std::holds_alternative<Problem>(result) ? std::get<Problem>(result).what : "";
    };
    EXPECT_NE(refusal(0).find("5 times"), std::string::npos); // it stands 4 times
    EXPECT_NE(refusal(1, 4).find("5 times"), std::string::npos);
    EXPECT_NE(refusal(-0.5).find("not on the curve"), std::string::npos);
    EXPECT_NE(refusal(2.5).find("not on the curve"), std::string::npos);
    EXPECT_NE(refusal(std::nan("")).find("not on the curve"), std::string::npos);
    EXPECT_NE(refusal(1, 0).find("0 times"), std::string::npos);
    EXPECT_NE(refusal(0.5, 2'000'000'000).find("2000000000 times"), std::string::npos);
    EXPECT_TRUE(std::holds_alternative<Curve>(withKnot(curve, 1, 3)));
    EXPECT_TRUE(std::holds_alternative<Curve>(withKnot(curve, 0.5, 4)));
    curve.closed = true;
    EXPECT_NE(refusal(2, 3).find("4 times"), std::string::npos);
    curve.family = "cardinal";
    curve.ends = Ends::doubled;
    EXPECT_NE(refusal(0.5).find("no knots"), std::string::npos);
    EXPECT_TRUE(std::holds_alternative<Problem>(elevated(curve)));
}

TEST(Insertion, acrossTheSeamOfAClosedCurve) {
    Curve curve;
    curve.family = "b-spline";
    curve.closed = true;
    curve.ends = Ends::none;
    curve.points = {{1, 2}, {3, 5}, {14, 4}};
    for (const auto& knots : {std::vector<double>{0, 0.5, 1, 1}, {0, 0, 0.25, 1}, {3, 4, 5, 7}}) {
        curve.knots = knots;
        for (const double t : {knots.front(), knots.back(), lerp(knots[1], knots[2], 0.3)}) {
            Dice dice(3);
            const auto result = withKnot(curve, t);
            ASSERT_TRUE(std::holds_alternative<Curve>(result)) << std::get<Problem>(result).what;
            expectSameByParameter(curve, std::get<Curve>(result), dice, 1e-13);
        }
    }
}

TEST(Elevated, aPolygonBecomesBezierPoints) {
    Curve curve;
    curve.family = "bezier";
    curve.ends = Ends::none;
    curve.points = {{101, 7}, {104, 13}};
    const auto once = std::get<Curve>(elevated(curve));
    EXPECT_EQ(once.points, (Points{{101, 7}, {102.5, 10}, {104, 13}}));
    curve.points = Points(1);
    for (int i = 0; i < 256; ++i) {
        curve.points.append(Point{double(i % 7)});
    }
    curve.coordinates = {"x"};
    const auto result = elevated(curve); // more points than a Bézier curve may have
    EXPECT_TRUE(std::holds_alternative<Problem>(result));
}

TEST(Elevated, stopsAtTheHighestDegree) {
    Curve curve;
    curve.family = "nurbs";
    curve.ends = Ends::clamped;
    curve.parameters["degree"] = 24;
    curve.coordinates = {"x"};
    curve.points = Points(1);
    for (int i = 0; i < 27; ++i) {
        curve.points.append(Point{5 + std::sin(i)});
        curve.weights.push_back(1 + 0.1 * (i % 5));
    }
    const auto result = elevated(curve);
    ASSERT_TRUE(std::holds_alternative<Curve>(result)) << std::get<Problem>(result).what;
    EXPECT_LE(differenceOf(piecesOf(curve), piecesOf(std::get<Curve>(result)))->most, 1e-10);
    const auto beyond = elevated(std::get<Curve>(result));
    ASSERT_TRUE(std::holds_alternative<Problem>(beyond));
    EXPECT_NE(std::get<Problem>(beyond).place.find("degree"), std::string::npos);
}

TEST(Elevated, hugeCoordinatesStayFinite) {
    for (const auto& [family, size] : {std::pair("b-spline", 1e299), std::pair("nurbs", 1e249)}) {
        Curve curve;
        curve.family = family;
        curve.ends = Ends::clamped;
        for (const auto& place : {Point{1, 2}, {3, -5}, {4, 4}, {7, 8}, {9, 1}}) {
            curve.points.append(size * place);
        }
        if (familyOf(curve).usesWeights) {
            curve.weights = {1, 2, 0.5, 3, 1};
        }
        for (const auto& result : {elevated(curve), withKnot(curve, 0.7)}) {
            const auto& found = std::get<Curve>(result);
            EXPECT_FALSE(problemOf(found));
            expectNear(piecesOf(found).position({0, 0}), piecesOf(curve).position({0, 0}),
                       1e-13 * size, family);
        }
    }
}

} // namespace
} // namespace splineloft
