// Points deleted so that the curve stays where it was as well as it can.
#include "core/document/edits.h"
#include "core/spline/change/knots.h"
#include "tests/documents.h"
#include "tests/property/nearness.h"
#include "tests/property/random_curves.h"

#include <cmath>
#include <numbers>

namespace splineloft::testing_curves {
namespace {

class HealLaws : public EveryFamily {};

Pieces firstPieces(const Document& document) {
    return piecesOf(*document.curves[0]);
}

TEST_P(HealLaws, aHealedCurveIsNeverFartherThanOneJustWithoutThePoints) {
    std::uint64_t seed = 0;
    int better = 0;
    forEveryForm(GetParam(), 7, [&](const Curve& curve) {
        Dice dice(++seed);
        const Document before = documentOf(curve);
        std::vector<PointId> ids;
        for (int i = dice.whole(1, 2); i > 0; --i) {
            const int step = familyOf(curve).hasHandles && dice.oneIn(2) ? 3 : 1;
            const int last = (static_cast<int>(curve.points.size()) - 1) / step;
            ids.push_back({0, static_cast<std::size_t>(step * dice.whole(0, last))});
        }
        const Document plain = deletePoints(before, ids);
        const Document healed = deleteAndHeal(before, ids);
        ASSERT_EQ(healed.curves.size(), plain.curves.size());
        if (healed.curves.empty()) {
            return;
        }
        ASSERT_FALSE(problemOf(healed));
        ASSERT_EQ(healed.curves[0]->points.size(), plain.curves[0]->points.size());
        const Pieces old = piecesOf(curve);
        const Pieces left = firstPieces(plain);
        if (left.empty()) {
            EXPECT_EQ(healed, plain);
            return;
        }
        const double without = farthestApart(left, old);
        const double with = farthestApart(firstPieces(healed), old);
        // The samples are not those by which it was measured.
        EXPECT_LE(with, 1.05 * without + 1e-9);
        better += with < 0.8 * without ? 1 : 0;
    });
    // The few rounds under the sanitizers need not meet a curve that gains by it.
    if (!underSanitizers && GetParam() != "linear" && GetParam() != "lagrange") {
        EXPECT_GT(better, 0) << "it is worth while";
    }
}

INSTANTIATE_TEST_SUITE_P(Families, HealLaws, testing::ValuesIn(familyIds()), testNameOf);

TEST(HealLaws, whatWasCutIntoABezierSplineHealsWithoutATrace) {
    for (const bool closed : {false, true}) {
        for (std::uint64_t seed = 0; seed < 40; ++seed) {
            Dice dice(seed);
            Curve curve = emptyCurve({"bezier-spline", closed, Ends::none}, 2);
            rollPoints(curve, closed ? 9 : 10, {90, -30}, 20, dice);
            const Pieces old = piecesOf(curve);
            const auto segment = static_cast<std::size_t>(dice.whole(0, 2));
            auto cut = insertOnCurve(documentOf(curve), 0, {segment, dice.between(0.1, 0.5)});
            const auto second =
                insertOnCurve(cut.document, 0, {segment + 1, dice.between(0.2, 0.8)});
            const std::vector<PointId> ids = {cut.point, second.point};
            const Document healed = deleteAndHeal(second.document, ids);
            EXPECT_LE(farthestApart(firstPieces(healed), old), 1e-9) << "seed " << seed;
            EXPECT_EQ(healed.curves[0]->points.size(), curve.points.size());
        }
    }
}

TEST(HealLaws, whatWasAddedToABSplineHealsWithoutATrace) {
    for (const std::string family : {"b-spline", "nurbs"}) {
        for (std::uint64_t seed = 0; seed < 20; ++seed) {
            Dice dice(seed);
            Curve curve = emptyCurve({family, false, Ends::clamped}, 2);
            rollPoints(curve, 9, {90, -30}, 20, dice);
            const Pieces old = piecesOf(curve);
            const auto added = insertOnCurve(documentOf(curve), 0, {3, 0.5});
            const Document healed =
                deleteAndHeal(added.document, std::vector<PointId>{added.point});
            EXPECT_LE(farthestApart(firstPieces(healed), old), 1e-6) << family << seed;
        }
    }
}

TEST(HealLaws, aBezierCurveOfOneDegreeMoreThanItNeedsHealsWithoutATrace) {
    Dice dice(4);
    Curve curve = emptyCurve({"bezier", false, Ends::none}, 2);
    rollPoints(curve, 6, {90, -30}, 20, dice);
    const Curve higher = std::get<Curve>(elevated(curve));
    const Document healed = deleteAndHeal(documentOf(higher), std::vector<PointId>{{0, 3}});
    EXPECT_LE(farthestApart(firstPieces(healed), piecesOf(curve)), 1e-6);
}

TEST(HealLaws, aCircleStaysRound) {
    for (const std::string family : {"cardinal", "catmull-rom", "hermite", "natural"}) {
        Curve curve = emptyCurve({family, true, formsOf(family).front().ends}, 2);
        for (int i = 0; i < 12; ++i) {
            const double angle = i * std::numbers::pi / 6;
            curve.points.append({200 + 50 * std::cos(angle), 50 * std::sin(angle)});
            if (familyOf(curve).usesTangents) {
                curve.tangents.append({-26 * std::sin(angle), 26 * std::cos(angle)});
            }
        }
        const Pieces old = piecesOf(curve);
        for (const std::size_t index : {0U, 5U, 11U}) { // also beside the seam
            const std::vector<PointId> ids = {{0, index}};
            const double without =
                farthestApart(firstPieces(deletePoints(documentOf(curve), ids)), old);
            const double with =
                farthestApart(firstPieces(deleteAndHeal(documentOf(curve), ids)), old);
            EXPECT_LT(with, 0.7 * without) << family << ' ' << index;
        }
    }
}

TEST(HealLaws, pointsDeletedAtAnEndLeaveNothingToHeal) {
    for (const std::string family : {"cardinal", "hermite", "bezier-spline", "b-spline"}) {
        Dice dice(8);
        Curve curve = emptyCurve({family, false, formsOf(family).front().ends}, 2);
        rollPoints(curve, 10, {9, 9}, 20, dice);
        const std::vector<PointId> ends = {{0, 0}, {0, 9}};
        EXPECT_EQ(deleteAndHeal(documentOf(curve), ends), deletePoints(documentOf(curve), ends));
    }
    EXPECT_TRUE(deleteAndHeal(documentOf(randomCurve({"linear", false, Ends::none}, 1)),
                              std::vector<PointId>{{0, 0}, {0, 1}})
                    .curves.size() <= 1);
}

} // namespace
} // namespace splineloft::testing_curves
