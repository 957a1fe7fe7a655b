// A control point added on a curve: where families can, the curve stays where it was.
#include "core/document/edits.h"
#include "tests/property/nearness.h"
#include "tests/property/random_curves.h"

namespace splineloft::testing_curves {
namespace {

class InsertionLaws : public EveryFamily {};

TEST_P(InsertionLaws, keepsTheShapeOrLandsOnTheOldCurve) {
    int round = 0;
    forEveryForm(GetParam(), 12, [&](const Curve& curve) {
        Dice dice(static_cast<std::uint64_t>(++round));
        const Document before = {{std::make_shared<Curve>(curve)}, "{}"};
        const Pieces old = piecesOf(curve);
        const Spot spot{static_cast<std::size_t>(dice.whole(0, static_cast<int>(old.size()) - 1)),
                        dice.between(0.01, 0.99)};
        const Inserted result = insertOnCurve(before, 0, spot);
        const Curve& now = *result.document.curves[0];
        if (now.points.size() > familyOf(now).mostPoints) {
            return;
        }
        ASSERT_FALSE(problemOf(result.document)) << problemOf(now)->what;
        const double rounding = 100 * roundingOf(now, blendsOf(now));
        EXPECT_EQ(result.keepsShape, insertionKeepsShape(curve));
        if (result.keepsShape) {
            EXPECT_LE(farthestApart(old, piecesOf(now)), rounding);
        }
        if (!familyOf(curve).usesKnots) {
            expectNear(now.points.at(result.point.index), old.position(spot), 1e-12 * farthest(now),
                       "the new point");
        }
    });
}

INSTANTIATE_TEST_SUITE_P(Families, InsertionLaws, testing::ValuesIn(familyIds()), testNameOf);

TEST(InsertionLaws, aNewKnotOfAWeightedCurveKeepsItToo) {
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
        Dice dice(seed);
        Curve curve = randomCurve({"nurbs", seed % 2 == 0, Ends::clamped}, seed);
        for (std::size_t i = 0; i < curve.points.size(); ++i) {
            curve.weights.push_back(std::exp(dice.between(-2, 2)));
        }
        const Document before = {{std::make_shared<Curve>(curve)}, "{}"};
        const Pieces old = piecesOf(curve);
        const Spot spot{old.size() / 2, dice.between(0, 1)};
        const Inserted result = insertOnCurve(before, 0, spot);
        ASSERT_TRUE(result.keepsShape) << wordsOf(curve);
        EXPECT_LE(farthestApart(old, piecesOf(*result.document.curves[0])),
                  1e-11 * (1 + farthest(curve)))
            << wordsOf(curve);
    }
}

TEST(InsertionLaws, theNewPointOfABSplineIsNearTheSpot) {
    for (const bool closed : {false, true}) {
        Curve curve = emptyCurve({"b-spline", closed, Ends::clamped}, 2);
        curve.points = {{0, 0}, {10, 1}, {20, -1}, {30, 2}, {40, 0}, {50, 3}, {60, 0}, {20, 80}};
        const Document before = {{std::make_shared<Curve>(curve)}, "{}"};
        const Pieces old = piecesOf(curve);
        for (std::size_t segment = 0; segment < old.size(); ++segment) {
            const Inserted result = insertOnCurve(before, 0, {segment, 0.5});
            const Curve& now = *result.document.curves[0];
            const Point place = old.position({segment, 0.5});
            const double away = distance(now.points.at(result.point.index), place);
            for (std::size_t i = 0; i < now.points.size(); ++i) {
                EXPECT_LE(away, distance(now.points.at(i), place) + 6) << segment << ' ' << i;
            }
        }
    }
}

} // namespace
} // namespace splineloft::testing_curves
