// Where a curve can go, what a point can move, and what stays the same when points are renumbered.
#include "tests/property/random_curves.h"

#include "core/spline/traits.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace splineloft::testing_curves {
namespace {

class Shape : public EveryFamily {};

/// Local families and how many pieces one of their points may move: as many as read it.
std::size_t readersOf(const Curve& curve) {
    return static_cast<std::size_t>(layoutOf(curve).window);
}

TEST_P(Shape, movingAPointMovesItsOwnPiecesOnly) {
    if (GetParam() == "natural" || GetParam() == "bezier") {
        return; // global by nature
    }
    forEveryForm(GetParam(), usualRounds, [](const Curve& curve) {
        if (familyOf(curve).spacing == Spacing::chord || knotsFollowPoints(curve)) {
            return; // moved chords move the pieces, see below
        }
        Dice dice(5);
        const Pieces before = piecesOf(curve);
        for (std::size_t k = 0; k < curve.points.size(); ++k) {
            Curve moved = curve;
            const Point by = dice.pointOnGrid(curve.points.dimension(), 9);
            moved.points.set(k, curve.points.at(k) + by);
            const Pieces after = piecesOf(moved);
            std::size_t changed = 0;
            for (std::size_t i = 0; i < before.size(); ++i) {
                changed += std::ranges::equal(before[i].coordinates, after[i].coordinates) ? 0 : 1;
            }
            EXPECT_LE(changed, readersOf(curve)) << "point " << k;
        }
    });
}

TEST(ShapeOf, catmullRomWithChordsStaysLocal) {
    forEveryForm("catmull-rom", usualRounds, [](const Curve& curve) {
        const BlendPieces blends = blendsOf(curve);
        for (std::size_t i = 0; i < blends.size(); ++i) {
            const Blend basis = blends.basis({i, 0.4});
            EXPECT_LE(basis.shares().size(), 4u) << "segment " << i;
        }
    });
}

/// For points whose hull is known by its supporting directions: no point of the curve lies farther
/// out in any direction than the control points that it blends.
TEST_P(Shape, staysInTheHullWhereTheBadgeSaysSo) {
    forEveryForm(GetParam(), usualRounds, [](const Curve& curve) {
        const Pieces pieces = piecesOf(curve);
        const BlendPieces blends = blendsOf(curve);
        if (!traitsOf(curve, pieces, blends).inHull || curve.ends == Ends::reflected) {
            return;
        }
        Dice dice(3);
        const double slack = 4 * curve.points.dimension() * roundingOf(curve, blends);
        for (int direction = 0; direction < 12; ++direction) {
            const Point out = dice.pointOnGrid(curve.points.dimension(), 1);
            double reach = -std::numeric_limits<double>::infinity();
            for (std::size_t k = 0; k < curve.points.size(); ++k) {
                reach = std::max(reach, dot(out, curve.points.at(k)));
            }
            for (std::size_t i = 0; i < pieces.size(); ++i) {
                for (int k = 0; k <= 16; ++k) {
                    EXPECT_LE(dot(out, pieces.position({i, k / 16.0})), reach + slack)
                        << "segment " << i << " u " << k / 16.0;
                }
            }
        }
    });
}

TEST(ShapeOf, theConvexFamiliesIsInTheHull) {
    for (const auto* family : {"linear", "bezier", "bezier-spline", "b-spline", "duff", "beta"}) {
        forEveryForm(family, usualRounds, [](const Curve& curve) {
            const BlendPieces blends = blendsOf(curve);
            const bool mirrored = !curve.closed && curve.ends == Ends::reflected;
            EXPECT_TRUE(mirrored || traitsOf(curve, piecesOf(curve), blends).inHull);
        });
    }
}

TEST(ShapeOf, theInterpolatingCubicsLeavesTheHull) {
    for (const auto* family : {"cardinal", "catmull-rom", "natural"}) {
        Curve curve = emptyCurve({family, true, formsOf(family).front().ends}, 2);
        curve.points = {{100, 50}, {104, 51}, {105, 56}, {99, 57}, {97, 53}};
        const Traits traits = traitsOf(curve, piecesOf(curve), blendsOf(curve));
        EXPECT_FALSE(traits.inHull) << family;
        EXPECT_TRUE(traits.throughAll) << family;
    }
}

/// Renumbering the points of a closed curve renumbers its pieces and changes nothing else.
TEST_P(Shape, closedCurvesHaveNoFirstPoint) {
    forEveryForm(GetParam(), usualRounds, [](const Curve& curve) {
        const auto stride = static_cast<std::size_t>(layoutOf(curve).stride);
        if (!curve.closed || curve.points.size() % stride != 0) {
            return;
        }
        Curve shifted = curve;
        const auto n = curve.points.size();
        for (std::size_t k = 0; k < n; ++k) {
            shifted.points.set(k, curve.points.at((k + stride) % n));
            if (!curve.tangents.empty()) {
                shifted.tangents.set(k, curve.tangents.at((k + stride) % n));
            }
        }
        const Pieces before = piecesOf(curve);
        const Pieces after = piecesOf(shifted);
        ASSERT_EQ(before.size(), n / stride);
        const double tolerance = 4 * roundingOf(curve, blendsOf(curve));
        for (std::size_t i = 0; i < after.size(); ++i) {
            for (int k = 0; k <= after.degree(); ++k) {
                expectNear(after[i].bezierPoint(k), before[(i + 1) % before.size()].bezierPoint(k),
                           tolerance, "segment " + std::to_string(i));
            }
        }
    });
}

/// The same points from last to first. Going backwards turns tangents around, and makes the
/// speed ratio b1 into 1 / b1 and with it the tension b2 into b2 / b1^3.
Curve reversed(const Curve& curve) {
    Curve result = curve;
    const auto n = curve.points.size();
    for (std::size_t k = 0; k < n; ++k) {
        result.points.set(k, curve.points.at(n - 1 - k));
        if (!curve.tangents.empty()) {
            result.tangents.set(k, -1.0 * curve.tangents.at(n - 1 - k));
        }
    }
    if (curve.family == "beta") {
        const double bias = curve.parameters.at("bias");
        result.parameters["bias"] = 1 / bias;
        result.parameters["tension"] = curve.parameters.at("tension") / (bias * bias * bias);
    }
    if (curve.family == "kochanek-bartels") {
        result.parameters["bias"] = -curve.parameters.at("bias");
    }
    if (curve.family == "parametric-parabola") {
        result.parameters["mu"] = 1 - curve.parameters.at("mu");
    }
    return result;
}

/// Whether the curve read backwards begins where a piece begins: pieces of several points each only
/// do so where the last of them is complete, and around a loop not at all.
bool canBeReversed(const Curve& curve) {
    const auto stride = static_cast<std::size_t>(layoutOf(curve).stride);
    return stride == 1 || curve.family == "bezier" || curve.family == "lagrange" ||
           (!curve.closed && curve.points.size() % stride == 1);
}

TEST_P(Shape, pointsBackwardsAreTheCurveBackwards) {
    forEveryForm(GetParam(), usualRounds, [](const Curve& curve) {
        if (!canBeReversed(curve)) {
            return;
        }
        const Pieces forth = piecesOf(curve);
        const Pieces back = piecesOf(reversed(curve));
        ASSERT_EQ(forth.size(), back.size());
        const auto n = forth.size();
        const int degree = forth.degree();
        // Around a loop piece 0 lies between points 0 and 1; with even degree it lies around 1.
        const std::size_t turn = !curve.closed ? 0 : degree % 2 == 0 ? 2 : 1;
        const double tolerance = 4 * roundingOf(curve, blendsOf(curve));
        for (std::size_t i = 0; i < n; ++i) {
            const auto mirror = (2 * n - 1 - i - turn) % n;
            for (int k = 0; k <= degree; ++k) {
                expectNear(back[i].bezierPoint(k), forth[mirror].bezierPoint(degree - k), tolerance,
                           "segment " + std::to_string(i) + " Bézier point " + std::to_string(k));
            }
        }
    });
}

/// Families that are the same at some value of their parameters.
TEST(ShapeOf, familiesThatCoincide) {
    struct Twins {
        std::string one, other;
        std::map<std::string, double> oneParameters, otherParameters;
    };
    const std::vector<Twins> twins = {
        {"cardinal", "catmull-rom", {{"tension", 0.5}}, {{"alpha", 0}}},
        {"bc-spline", "cardinal", {{"b", 0}, {"c", 0.7}}, {{"tension", 0.7}}},
        {"bc-spline", "duff", {{"b", 0.4}, {"c", 0}}, {{"tension", 0.4}}},
        {"bc-spline", "b-spline", {{"b", 1}, {"c", 0}}, {{"degree", 3}}},
        {"kochanek-bartels", "cardinal", {{"tension", 0}}, {{"tension", 0.5}}},
        {"kochanek-bartels", "cardinal", {{"tension", 0.3}}, {{"tension", 0.35}}},
        {"b-spline", "duff", {{"degree", 3}}, {{"tension", 1}}},
        {"b-spline", "beta", {{"degree", 3}}, {{"bias", 1}, {"tension", 0}}},
        {"duff", "beta", {{"tension", 0.3}}, {{"bias", 1}, {"tension", 12 * 0.7 / 0.3}}},
    };
    for (const auto& pair : twins) {
        for (const bool closed : {false, true}) {
            for (const Ends ends : {Ends::doubled, Ends::open, Ends::reflected}) {
                Dice dice(77);
                Curve one = emptyCurve({pair.one, closed, ends}, 3);
                one.parameters = pair.oneParameters;
                rollPoints(one, 8, {500, -300, 40}, 20, dice);
                Curve other = one;
                other.family = pair.other;
                other.parameters = pair.otherParameters;
                const Pieces a = piecesOf(one);
                const Pieces b = piecesOf(other);
                ASSERT_EQ(a.size(), b.size());
                const double tolerance = 2 * roundingOf(one, blendsOf(one));
                for (std::size_t i = 0; i < a.size(); ++i) {
                    for (const double u : {0.0, 0.3, 1.0}) {
                        expectNear(a.position({i, u}), b.position({i, u}), tolerance,
                                   wordsOf(one) + " and " + wordsOf(other));
                    }
                }
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Families, Shape, testing::ValuesIn(familyIds()), testNameOf);

} // namespace
} // namespace splineloft::testing_curves
