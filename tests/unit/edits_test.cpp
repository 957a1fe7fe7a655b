// Edits are functions from document to document: what they change, what they leave alone, and that
// they never make a document that could not be drawn.
#include "core/document/edits.h"
#include "core/document/handles.h"

#include "core/spline/catalog.h"
#include "tests/unit/edited_curves.h"

#include <algorithm>

namespace splineloft {
namespace {

using namespace testing_curves;

TEST(Insert, onABezierSplineKeepsTheShape) {
    for (const bool closed : {false, true}) {
        const Curve curve = planeCurve("bezier-spline", closed ? 9 : 10, closed);
        const Document before = besideBystander(curve);
        const Pieces old = piecesOf(curve);
        for (std::size_t segment = 0; segment < old.size(); ++segment) {
            const double at = 0.3;
            const Inserted result = insertOnCurve(before, 0, {segment, at});
            const Curve& now = firstOf(result.document);
            expectPlausible(before, result.document, "insert");
            const Pieces pieces = piecesOf(now);
            ASSERT_EQ(pieces.size(), old.size() + 1) << segment;
            EXPECT_EQ(now.points.at(result.point.index), old.position({segment, at})) << segment;
            for (std::size_t i = 0; i < pieces.size(); ++i) {
                const bool half = i == segment || i == segment + 1;
                const Spot was{i > segment ? i - 1 : i, !half          ? 0.6
                                                        : i == segment ? 0.6 * at
                                                                       : at + 0.6 * (1 - at)};
                expectNear(pieces.position({i, 0.6}), old.position(was), 1e-12,
                           (closed ? "closed, cut " : "cut ") + std::to_string(segment) +
                               " piece " + std::to_string(i));
            }
        }
    }
}

TEST(Insert, elsewhereTheNewPointLandsOnTheOldCurve) {
    for (const auto& form : everyForm()) {
        const Curve curve = planeCurve(form.family, 7, form.closed);
        if (familyOf(curve).hasHandles || familyOf(curve).usesKnots) {
            continue;
        }
        const Document before = besideBystander(curve);
        const Pieces old = piecesOf(curve);
        for (std::size_t segment = 0; segment < old.size(); ++segment) {
            const Spot spot{segment, 0.4};
            const Inserted result = insertOnCurve(before, 0, spot);
            expectPlausible(before, result.document, wordsOf(curve));
            EXPECT_EQ(result.keepsShape, form.family == "linear");
            EXPECT_EQ(insertionKeepsShape(curve), form.family == "linear");
            EXPECT_EQ(firstOf(result.document).points.size(), 8u);
            EXPECT_EQ(firstOf(result.document).points.at(result.point.index), old.position(spot))
                << wordsOf(curve) << " segment " << segment;
        }
    }
}

TEST(Append, addsAfterTheLastAndGivesBezierSplinesTheirHandles) {
    for (const auto& id : familyIds()) {
        Document document =
            addCurve(Document(), emptyCurve({id, false, formsOf(id).front().ends}, 2));
        for (int i = 0; i < 5; ++i) {
            const Point place = {100.0 + 9 * i, 40.0 + i * i};
            const Inserted result = appendPoint(document, 0, place);
            document = result.document;
            EXPECT_EQ(firstOf(document).points.at(result.point.index), place) << id;
            EXPECT_FALSE(problemOf(document)) << id;
        }
        EXPECT_EQ(firstOf(document).points.size(), id == "bezier-spline" ? 13u : 5u) << id;
    }
}

TEST(Delete, takesPointsAndTheirTangents) {
    const Document before = besideBystander(planeCurve("hermite", 6));
    const Document after = deletePoints(before, std::vector<PointId>{{0, 5}, {0, 1}, {0, 1}});
    expectPlausible(before, after, "delete");
    ASSERT_EQ(firstOf(after).points.size(), 4u);
    EXPECT_EQ(firstOf(after).points.at(1), firstOf(before).points.at(2));
    EXPECT_EQ(firstOf(after).tangents.at(1), firstOf(before).tangents.at(2));
}

TEST(Delete, takesTheCurveWithItsLastPoint) {
    const Document before = besideBystander(planeCurve("cardinal", 2));
    const Document after = deletePoints(before, std::vector<PointId>{{0, 0}, {0, 1}});
    ASSERT_EQ(after.curves.size(), 1u);
    EXPECT_EQ(after.curves[0], before.curves[1]);
}

/// Which old points are left after deleting an anchor of a Bézier spline.
std::vector<std::size_t> leftAfterDeleting(const Curve& curve, std::size_t anchor) {
    const Document after = deletePoints(besideBystander(curve), std::vector<PointId>{{0, anchor}});
    std::vector<std::size_t> left;
    for (std::size_t i = 0; i < firstOf(after).points.size(); ++i) {
        for (std::size_t k = 0; k < curve.points.size(); ++k) {
            if (firstOf(after).points.at(i) == curve.points.at(k)) {
                left.push_back(k);
            }
        }
    }
    return left;
}

TEST(Delete, anAnchorGoesWithItsHandles) {
    using Indices = std::vector<std::size_t>;
    const Curve open = planeCurve("bezier-spline", 10);
    EXPECT_EQ(leftAfterDeleting(open, 0), (Indices{3, 4, 5, 6, 7, 8, 9}));
    EXPECT_EQ(leftAfterDeleting(open, 3), (Indices{0, 1, 5, 6, 7, 8, 9}));
    EXPECT_EQ(leftAfterDeleting(open, 9), (Indices{0, 1, 2, 3, 4, 5, 6}));
    const Curve closed = planeCurve("bezier-spline", 9, true);
    EXPECT_EQ(leftAfterDeleting(closed, 3), (Indices{0, 1, 5, 6, 7, 8}));
    EXPECT_EQ(leftAfterDeleting(closed, 6), (Indices{0, 1, 2, 3, 4, 8}));
    EXPECT_EQ(leftAfterDeleting(closed, 0), (Indices{3, 4, 5, 6, 7, 2}))
        << "8 and 1 are its handles";
}

TEST(Handles, knowTheirAnchorsAndPartners) {
    const Curve open = smoothBezierSpline();
    EXPECT_EQ(anchorOf(open, 2), 3u);
    EXPECT_EQ(anchorOf(open, 4), 3u);
    EXPECT_EQ(anchorOf(open, 3), std::nullopt);
    EXPECT_EQ(partnerOf(open, 2), 4u);
    EXPECT_EQ(partnerOf(open, 4), 2u);
    EXPECT_EQ(partnerOf(open, 1), std::nullopt) << "at the start";
    EXPECT_EQ(partnerOf(open, 5), std::nullopt) << "at the end";
    const Curve closed = planeCurve("bezier-spline", 9, true);
    EXPECT_EQ(anchorOf(closed, 8), 0u);
    EXPECT_EQ(partnerOf(closed, 8), 1u);
    EXPECT_EQ(partnerOf(closed, 1), 8u);
    EXPECT_EQ(anchorOf(planeCurve("cardinal", 5), 2), std::nullopt) << "no handles";
}

/// One random edit of curve 0.
Document randomlyEdited(const Document& document, Dice& dice) {
    const Curve& curve = *document.curves[0];
    const auto any = static_cast<std::size_t>(
        dice.whole(0, std::max(0, static_cast<int>(curve.points.size()) - 1)));
    const auto ids = familyIds();
    switch (dice.whole(0, 7)) {
    case 0: return movePoints(document, std::vector<PointId>{{0, any}}, dice.pointOnGrid(2, 5));
    case 1: return setPoint(document, {0, any}, dice.pointOnGrid(2, 50));
    case 2: return appendPoint(document, 0, dice.pointOnGrid(2, 50)).document;
    case 3:
        return curve.points.size() > 1 ? deletePoints(document, std::vector<PointId>{{0, any}})
                                       : document;
    case 4: return setClosed(document, 0, familyOf(curve).closable && dice.oneIn(2));
    case 5: return setEnds(document, 0, familyOf(curve).ends.back());
    case 6: {
        const Pieces pieces = piecesOf(curve);
        return pieces.empty() ? document
                              : insertOnCurve(document, 0, pieces.knots().locate(0.4)).document;
    }
    default:
        return setFamily(
            document, 0,
            ids[static_cast<std::size_t>(dice.whole(0, static_cast<int>(ids.size()) - 1))]);
    }
}

TEST(Edits, inAnyOrderMakeDrawableDocumentsAndLeaveTheOldOnesAlone) {
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
        Dice dice(seed);
        Document document = besideBystander(planeCurve("cardinal", 4));
        for (int step = 0; step < 60; ++step) {
            const Document before = document;
            const Curve copy = *before.curves[0];
            Document next = randomlyEdited(document, dice);
            ASSERT_EQ(*before.curves[0], copy) << "seed " << seed << " step " << step;
            if (next.curves.size() < 2) {
                break; // the last anchor is gone, and with it the curve
            }
            if (next.curves[0]->points.size() > familyOf(*next.curves[0]).mostPoints) {
                continue; // more than the family takes: the session would refuse it
            }
            ASSERT_FALSE(problemOf(next)) << "seed " << seed << " step " << step << ": "
                                          << problemOf(next)->place << ' ' << problemOf(next)->what;
            ASSERT_EQ(next.curves[1], before.curves[1]);
            ASSERT_NO_THROW(piecesOf(*next.curves[0])) << "seed " << seed << " step " << step;
            document = std::move(next);
        }
    }
}

} // namespace
} // namespace splineloft
