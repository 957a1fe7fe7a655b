// Curves turned around, cut, opened and joined: every family's shape stays, as far as it can.
#include "core/document/curve_edits.h"
#include "core/document/edits.h"
#include "tests/property/nearness.h"
#include "tests/property/random_curves.h"

#include "core/spline/change/shape.h"

namespace splineloft::testing_curves {
namespace {

class CurveEditLaws : public EveryFamily {};

Document twiceInOne(const Curve& curve) {
    return {{std::make_shared<Curve>(curve), std::make_shared<Curve>(curve)}, "{}"};
}

double toleranceFor(const Pieces& pieces) {
    return 10 * conversion::toleranceOf(pieces);
}

/// Random values at each control point, where the family lets its parameters have them.
Curve withLocal(Curve curve, std::uint64_t seed) {
    Dice dice(seed);
    for (const auto& p : familyOf(curve).parameters) {
        if (p.local && !(curve.family == "beta" && p.key == "bias")) {
            for (std::size_t i = 0; i < curve.points.size(); ++i) {
                curve.local[std::string(p.key)].push_back(
                    dice.between(p.sliderLeast, p.sliderMost));
            }
        }
    }
    return curve;
}

void expectReversed(const Curve& curve) {
    const Document before = twiceInOne(curve);
    const Document after = reverseCurve(before, 0);
    ASSERT_FALSE(problemOf(after)) << problemOf(after)->place << ' ' << problemOf(after)->what;
    const Pieces old = piecesOf(curve);
    const Pieces now = piecesOf(*after.curves[0]);
    ASSERT_EQ(now.size(), old.size());
    const double tolerance = toleranceFor(old);
    for (std::size_t i = 0; i < now.size(); ++i) {
        for (const double u : {0.0, 0.3, 1.0}) {
            expectNear(now.position({i, u}), old.position({old.size() - 1 - i, 1 - u}), tolerance,
                       "piece " + std::to_string(i));
        }
    }
    const Document back = reverseCurve(after, 0);
    EXPECT_EQ(back.curves[0]->points, curve.points);
    EXPECT_EQ(back.curves[0]->tangents, curve.tangents);
    EXPECT_EQ(after.curves[1], before.curves[1]);
}

TEST_P(CurveEditLaws, aReversedCurveIsTheSameBackwards) {
    std::uint64_t seed = 0;
    forEveryForm(GetParam(), 10, [&](const Curve& curve) {
        if (curve.family == "beta" &&
            parameterOf(curve, "tension") > 1e5 * std::pow(parameterOf(curve, "bias"), 3)) {
            return; // backwards it would need more tension than there is
        }
        expectReversed(curve);
        expectReversed(withLocal(curve, ++seed));
    });
}

TEST_P(CurveEditLaws, bothPartsOfACutCurveKeepItsShape) {
    std::uint64_t seed = 0;
    forEveryForm(GetParam(), 7, [&](const Curve& rolled) {
        Dice dice(++seed);
        const Curve curve = dice.oneIn(2) ? withLocal(rolled, seed) : rolled;
        const Pieces old = piecesOf(curve);
        const Spot spot{static_cast<std::size_t>(dice.whole(0, static_cast<int>(old.size()) - 1)),
                        dice.oneIn(3) && old.size() > 2 ? 1 : dice.between(0.01, 0.99)};
        const auto result = splitCurve(twiceInOne(curve), 0, spot);
        const bool atEnd = spot.u == 1 && spot.segment + 1 == old.size() && !curve.closed;
        if (old.degree() > 25 || atEnd) {
            ASSERT_EQ(std::holds_alternative<Problem>(result), atEnd || old.degree() > 25);
            return;
        }
        ASSERT_TRUE(std::holds_alternative<Document>(result)) << std::get<Problem>(result).what;
        const auto& after = std::get<Document>(result);
        ASSERT_FALSE(problemOf(after)) << problemOf(after)->what;
        ASSERT_EQ(after.curves.size(), curve.closed ? 2u : 3u);
        const double tolerance = toleranceFor(old);
        const Pieces first = piecesOf(*after.curves[0]);
        EXPECT_FALSE(after.curves[0]->closed);
        if (curve.closed) {
            EXPECT_LE(farthestApart(first, old), tolerance);
            expectNear(first.position({0, 0}), old.position(spot), tolerance, "where it starts");
        } else {
            const Pieces second = piecesOf(*after.curves[1]);
            EXPECT_LE(farthestFrom(first, old), tolerance);
            EXPECT_LE(farthestFrom(second, old), tolerance);
            expectNear(first.position({0, 0}), old.position({0, 0}), tolerance, "start");
            expectNear(first.position({first.size() - 1, 1}), old.position(spot), tolerance, "cut");
            expectNear(second.position({0, 0}), old.position(spot), tolerance, "cut");
            expectNear(second.position({second.size() - 1, 1}), old.position({old.size() - 1, 1}),
                       tolerance, "end");
        }
    });
}

TEST_P(CurveEditLaws, aClosedCurveOpensWhereItPassesByAPoint) {
    forEveryForm(GetParam(), 3, [&](const Curve& curve) {
        if (!curve.closed) {
            return;
        }
        const Pieces old = piecesOf(curve);
        for (std::size_t i = 0; i < curve.points.size(); ++i) {
            const auto result = openAt(twiceInOne(curve), {0, i});
            ASSERT_TRUE(std::holds_alternative<Document>(result)) << std::get<Problem>(result).what;
            const Curve& opened = *std::get<Document>(result).curves[0];
            EXPECT_FALSE(opened.closed);
            const Pieces now = piecesOf(opened);
            EXPECT_LE(farthestApart(now, old), toleranceFor(old)) << i;
            const bool passes = curve.family == "linear" || curve.family == "cardinal" ||
                                curve.family == "natural" || curve.family == "hermite";
            if (passes) {
                expectNear(now.position({0, 0}), curve.points.at(i), toleranceFor(old), "start");
            }
        }
    });
}

INSTANTIATE_TEST_SUITE_P(Families, CurveEditLaws, testing::ValuesIn(familyIds()), testNameOf);

TEST(CurveEditLaws, knotsOfItsOwnAreMirroredAndCut) {
    for (const bool closed : {false, true}) {
        for (const int degree : {1, 2, 3, 4}) {
            Dice dice(static_cast<std::uint64_t>(degree));
            Curve curve = emptyCurve({"nurbs", closed, Ends::none}, 2);
            curve.parameters = {{"degree", degree}, {"alpha", 0}};
            rollPoints(curve, 9, {30, -10}, 9, dice);
            const auto count =
                curve.points.size() + (closed ? 1 : static_cast<unsigned>(degree) + 1);
            for (std::size_t i = 0; i < count; ++i) {
                curve.knots.push_back((curve.knots.empty() ? 3 : curve.knots.back()) +
                                      dice.whole(closed ? 1 : 0, 3) + (i % 3 == 0 ? 0.5 : 0));
            }
            for (std::size_t i = 0; i < curve.points.size(); ++i) {
                curve.weights.push_back(dice.between(0.3, 3));
            }
            ASSERT_FALSE(problemOf(curve)) << problemOf(curve)->what;
            expectReversed(curve);
            const Pieces old = piecesOf(curve);
            const auto result = splitCurve(twiceInOne(curve), 0, {old.size() / 2, 0.4});
            ASSERT_TRUE(std::holds_alternative<Document>(result)) << std::get<Problem>(result).what;
            const auto& after = std::get<Document>(result);
            EXPECT_LE(farthestFrom(piecesOf(*after.curves[0]), old), toleranceFor(old));
            EXPECT_EQ(after.curves[0]->knots.front(),
                      after.curves[0]->knots[static_cast<unsigned>(degree)])
                << "it starts at its first point";
        }
    }
}

TEST(CurveEditLaws, splitAndJoinedAgainItIsTheSameCurve) {
    for (const std::string family : {"linear", "bezier-spline", "b-spline", "nurbs"}) {
        forEveryForm(family, 6, [&](const Curve& curve) {
            if (curve.closed) {
                return;
            }
            const Pieces old = piecesOf(curve);
            const Document whole = {{std::make_shared<Curve>(curve)}, "{}"};
            const auto split = splitCurve(whole, 0, {old.size() / 2, 0.37});
            ASSERT_TRUE(std::holds_alternative<Document>(split));
            auto parts = std::get<Document>(split);
            for (const int turned : {0, 1, 2, 3}) { // whichever way they run
                Document turnedParts = turned % 2 == 1 ? reverseCurve(parts, 0) : parts;
                turnedParts = turned / 2 == 1 ? reverseCurve(turnedParts, 1) : turnedParts;
                const auto last = [&](std::size_t i) {
                    return turnedParts.curves[i]->points.size() - 1;
                };
                const PointId end = {0, turned % 2 == 1 ? 0 : last(0)};
                const PointId other = {1, turned / 2 == 1 ? last(1) : 0};
                const auto joined = joinCurves(turnedParts, end, other);
                ASSERT_TRUE(std::holds_alternative<Document>(joined))
                    << std::get<Problem>(joined).what;
                const auto& result = std::get<Document>(joined);
                ASSERT_EQ(result.curves.size(), 1u);
                EXPECT_LE(farthestApart(piecesOf(*result.curves[0]), old), toleranceFor(old))
                    << turned;
            }
        });
    }
}

} // namespace
} // namespace splineloft::testing_curves
