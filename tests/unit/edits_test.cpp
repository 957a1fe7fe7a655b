// Edits are functions from document to document: what they change, what they leave alone, and that
// they never make a document that could not be drawn.
#include "core/document/edits.h"
#include "core/document/handles.h"

#include "core/spline/catalog.h"
#include "tests/documents.h"
#include "tests/property/random_curves.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>

namespace splineloft {
namespace {

using namespace testing_curves;

Curve planeCurve(const std::string& family, std::size_t count, bool closed = false) {
    Dice dice(count + 31);
    Curve curve = emptyCurve({family, closed, formsOf(family).front().ends}, 2);
    rollPoints(curve, count, {200, -70}, 20, dice);
    return curve;
}

/// Two curves: the one given, and a bystander that no edit may touch.
Document besideBystander(Curve curve) {
    Document document;
    document.curves = {std::make_shared<Curve>(std::move(curve)),
                       std::make_shared<Curve>(planeCurve("natural", 5))};
    return document;
}

void expectPlausible(const Document& before, const Document& after, const std::string& what) {
    const auto problem = problemOf(after);
    EXPECT_FALSE(problem) << what << ": " << problem->place << ' ' << problem->what;
    ASSERT_FALSE(after.curves.empty()) << what;
    EXPECT_EQ(after.curves.back(), before.curves.back()) << what << " shares the other curve";
}

/// Sums of coordinates of some hundreds, when rounded to 14 digits.
constexpr double digits = 5e-12;

TEST(MovePoints, leavesNoDustOfBinaryFractions) {
    Curve curve = emptyCurve({"cardinal", false, Ends::doubled}, 2);
    curve.points = {{0.1, 0.7}, {3, 4}};
    const Document after =
        movePoints(besideBystander(curve), std::vector<PointId>{{0, 0}}, {0.2, 0.1});
    EXPECT_EQ(firstOf(after).points.at(0), Point({0.3, 0.8}));
}

TEST(MovePoints, movesThoseByTheTotalAndNoOthers) {
    const Document before = besideBystander(planeCurve("cardinal", 6));
    const std::vector<PointId> ids = {{0, 1}, {0, 4}};
    const Document after = movePoints(before, ids, {3, -5});
    expectPlausible(before, after, "move");
    for (std::size_t i = 0; i < 6; ++i) {
        const Point was = firstOf(before).points.at(i);
        if (i == 1 || i == 4) {
            expectNear(firstOf(after).points.at(i), was + Point{3, -5}, digits, std::to_string(i));
        } else {
            EXPECT_EQ(firstOf(after).points.at(i), was) << i;
        }
    }
    EXPECT_EQ(movePoints(before, ids, {0, 0}), before) << "no way is no change";
    EXPECT_EQ(movePoints(before, {}, {3, -5}), before);
}

TEST(MovePoints, namedTwiceMovesOnce) {
    const Document before = besideBystander(planeCurve("cardinal", 4));
    const std::vector<PointId> twice = {{0, 2}, {0, 2}};
    EXPECT_EQ(movePoints(before, twice, {3, -5}),
              movePoints(before, std::vector<PointId>{{0, 2}}, {3, -5}));
}

TEST(MovePoints, leavesOutCoordinatesThatACurveLacks) {
    Document document = besideBystander(planeCurve("cardinal", 4));
    Curve flat = emptyCurve({"cardinal", false, Ends::doubled}, 1);
    flat.points = {{3}, {8}};
    document.curves[0] = std::make_shared<Curve>(flat);
    const Document after = movePoints(document, std::vector<PointId>{{0, 1}}, {3, -5});
    EXPECT_EQ(firstOf(after).points.at(1), Point{11});
}

TEST(MovePoints, movesTipsOfTangents) {
    const Document before = besideBystander(planeCurve("hermite", 4));
    const std::vector<PointId> tip = {{0, 2, Part::tangent}};
    const Document after = movePoints(before, tip, {3, -5});
    EXPECT_EQ(firstOf(after).points, firstOf(before).points);
    expectNear(firstOf(after).tangents.at(2), firstOf(before).tangents.at(2) + Point{3, -5}, digits,
               "tip");
}

/// Anchors at 0, 3, 6; the handles 2 and 4 are in line with anchor 3, and 4 is twice as far.
Curve smoothBezierSpline() {
    Curve curve = emptyCurve({"bezier-spline", false, Ends::none}, 2);
    curve.points = {{100, 50}, {103, 50}, {110, 56}, {113, 60}, {119, 68}, {125, 60}, {126, 50}};
    return curve;
}

TEST(MovePoints, anAnchorTakesItsHandlesWithIt) {
    const Document before = besideBystander(smoothBezierSpline());
    const Document after = movePoints(before, std::vector<PointId>{{0, 3}}, {7, 9});
    for (std::size_t i = 0; i < 7; ++i) {
        const Point was = firstOf(before).points.at(i);
        EXPECT_EQ(firstOf(after).points.at(i), i >= 2 && i <= 4 ? was + Point({7, 9}) : was) << i;
    }
}

TEST(MovePoints, aHandleTurnsItsPartnerAlong) {
    const Document before = besideBystander(smoothBezierSpline());
    // From (110, 56) to (113, 55): below the anchor, so the partner ends up above it, as far as
    // ever.
    const Document after = movePoints(before, std::vector<PointId>{{0, 2}}, {3, -1});
    expectNear(firstOf(after).points.at(2), {113, 55}, 0, "the handle itself");
    expectNear(firstOf(after).points.at(4), {113, 70}, 1e-12, "its partner");
    EXPECT_EQ(firstOf(after).points.at(3), Point({113, 60}));
}

TEST(MovePoints, aHandleOfACornerMovesAlone) {
    Curve curve = smoothBezierSpline();
    curve.points.set(4, {113, 68});
    const Document before = besideBystander(curve);
    const Document after = movePoints(before, std::vector<PointId>{{0, 2}}, {3, -1});
    EXPECT_EQ(firstOf(after).points.at(4), Point({113, 68}));
}

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

TEST(SetFamily, keepsThePointsAndMakesACurveThatCanBeDrawn) {
    for (const auto& form : everyForm()) {
        const Document before = besideBystander(planeCurve(form.family, 7, form.closed));
        for (const auto& family : familyIds()) {
            const Document after = setFamily(before, 0, family);
            expectPlausible(before, after, form.family + " to " + family);
            EXPECT_EQ(firstOf(after).points, firstOf(before).points);
            EXPECT_EQ(firstOf(after).family, family);
        }
        EXPECT_EQ(setFamily(before, 0, "spiral"), before) << "no such family";
    }
}

TEST(SetFamily, hermiteStartsAsCatmullRom) {
    for (const bool closed : {false, true}) {
        const Document before = besideBystander(planeCurve("cardinal", 6, closed));
        const Pieces cardinal = piecesOf(firstOf(before));
        const Document after = setFamily(before, 0, "hermite");
        const Pieces hermite = piecesOf(firstOf(after));
        ASSERT_EQ(hermite.size(), cardinal.size());
        for (std::size_t i = 0; i < hermite.size(); ++i) {
            expectNear(hermite.position({i, 0.3}), cardinal.position({i, 0.3}), 1e-12,
                       "segment " + std::to_string(i));
        }
    }
}

TEST(SetFamily, theUsualEndsBecomeTheUsualEnds) {
    const Document cardinal = besideBystander(planeCurve("cardinal", 5));
    EXPECT_EQ(firstOf(setFamily(cardinal, 0, "nurbs")).ends, Ends::clamped);
    EXPECT_EQ(firstOf(setFamily(setFamily(cardinal, 0, "nurbs"), 0, "cardinal")).ends,
              Ends::doubled);
    const Document chosen = setEnds(cardinal, 0, Ends::reflected);
    EXPECT_EQ(firstOf(setFamily(chosen, 0, "nurbs")).ends, Ends::reflected) << "as was wanted";
}

/// A closed or open NURBS curve of degree 2 that has every list it can have.
Curve fullNurbs() {
    Curve curve = planeCurve("nurbs", 4);
    curve.parameters = {{"degree", 2}, {"alpha", 0.5}};
    curve.ends = Ends::none;
    curve.knots = {0, 0, 0, 1, 3, 3, 3};
    curve.weights = {1, 2, 3, 4};
    return curve;
}

TEST(SetFamily, aBSplineAndNurbsKeepWhatBothHave) {
    const Document before = besideBystander(fullNurbs());
    const Document plain = setFamily(before, 0, "b-spline");
    EXPECT_EQ(firstOf(plain).knots, firstOf(before).knots);
    EXPECT_EQ(firstOf(plain).parameters, firstOf(before).parameters);
    EXPECT_EQ(firstOf(plain).ends, Ends::none);
    EXPECT_TRUE(firstOf(plain).weights.empty());
    const Document back = setFamily(plain, 0, "nurbs");
    EXPECT_EQ(firstOf(back).knots, firstOf(before).knots);
    const Document other = setFamily(before, 0, "cardinal");
    EXPECT_TRUE(firstOf(other).knots.empty());
    EXPECT_EQ(firstOf(other).ends, Ends::doubled);
    expectPlausible(before, other, "cardinal");
}

TEST(OwnKnots, giveWayToAnotherEndDegreeSpacingOrClosing) {
    const Document before = besideBystander(fullNurbs());
    for (const Document& after :
         {setEnds(before, 0, Ends::reflected), setParameter(before, 0, "degree", 3),
          setParameter(before, 0, "alpha", 1), setClosed(before, 0, true)}) {
        expectPlausible(before, after, "own knots");
        EXPECT_TRUE(firstOf(after).knots.empty());
        EXPECT_NE(firstOf(after).ends, Ends::none);
        EXPECT_EQ(firstOf(after).weights, firstOf(before).weights);
    }
    EXPECT_EQ(setParameter(before, 0, "degree", 2), before) << "the degree that they belong to";
    EXPECT_EQ(setClosed(before, 0, false), before);
    EXPECT_EQ(firstOf(setEnds(before, 0, Ends::open)).ends, Ends::open);
}

TEST(SetWeight, storesTheListFromTheFirstThatIsNotOne) {
    const Document before = besideBystander(planeCurve("nurbs", 4));
    const Document after = setWeight(before, 0, 2, 2.5);
    expectPlausible(before, after, "weight");
    EXPECT_EQ(firstOf(after).weights, (std::vector<double>{1, 1, 2.5, 1}));
    EXPECT_EQ(firstOf(after).points, firstOf(before).points);
    EXPECT_EQ(setWeight(after, 0, 2, 1), before) << "where all are 1 none are stored";
    EXPECT_EQ(firstOf(setWeight(after, 0, 0, 3)).weights, (std::vector<double>{3, 1, 2.5, 1}));
    EXPECT_EQ(setWeight(before, 0, 1, 1), before);
    EXPECT_EQ(setWeight(before, 0, 9, 2), before) << "no such point";
    const Document cardinal = besideBystander(planeCurve("cardinal", 4));
    EXPECT_EQ(setWeight(cardinal, 0, 1, 2), cardinal) << "no weights there";
    EXPECT_TRUE(problemOf(setWeight(before, 0, 1, 0))) << "to be refused in words";
}

TEST(Local, aParameterBecomesLocalWithoutAChangeOfShape) {
    Document before = besideBystander(planeCurve("cardinal", 5));
    before = setParameter(before, 0, "tension", 0.75);
    const Document after = makeLocal(before, 0, "tension");
    expectPlausible(before, after, "local");
    EXPECT_EQ(firstOf(after).local.at("tension"), std::vector<double>(5, 0.75));
    const Pieces now = piecesOf(firstOf(after));
    const Pieces was = piecesOf(firstOf(before));
    expectNear(now.position({1, 0.3}), was.position({1, 0.3}), 0, "the shape");
    EXPECT_EQ(makeLocal(after, 0, "tension"), after);
    EXPECT_EQ(makeGlobal(after, 0, "tension"), before);
    EXPECT_EQ(makeGlobal(before, 0, "tension"), before) << "it is already";
    EXPECT_EQ(makeLocal(before, 0, "slack"), before);
    const Document duff = besideBystander(planeCurve("duff", 5));
    EXPECT_EQ(makeLocal(duff, 0, "tension"), duff) << "not in this family";
}

TEST(Local, isSetAtSomePointsOrAtAll) {
    const Document before = besideBystander(planeCurve("kochanek-bartels", 4));
    const Document some = setLocal(before, 0, "bias", std::vector<std::size_t>{1, 3, 9}, 0.5);
    expectPlausible(before, some, "some");
    EXPECT_EQ(firstOf(some).local.at("bias"), (std::vector<double>{0, 0.5, 0, 0.5}));
    EXPECT_FALSE(firstOf(some).local.contains("tension"));
    const Document all = setLocal(some, 0, "bias", {}, -1);
    EXPECT_EQ(firstOf(all).local.at("bias"), std::vector<double>(4, -1));
    EXPECT_TRUE(problemOf(setLocal(some, 0, "bias", {}, 2))) << "to be refused in words";
    EXPECT_EQ(setLocal(before, 0, "slack", {}, 1), before);
}

TEST(Local, becomesOneValueAgain) {
    Document before = besideBystander(planeCurve("beta", 4));
    before = setParameter(before, 0, "tension", 7);
    const Document agreed = makeGlobal(setLocal(before, 0, "tension", {}, 20), 0, "tension");
    EXPECT_EQ(parameterOf(firstOf(agreed), "tension"), 20) << "on which all points agree";
    EXPECT_TRUE(firstOf(agreed).local.empty());
    const Document mixed = setLocal(before, 0, "tension", std::vector<std::size_t>{2}, 20);
    EXPECT_EQ(makeGlobal(mixed, 0, "tension"), before) << "the value from before";
}

TEST(SetClosed, aBezierSplineClosesSmoothlyAndOpensAgain) {
    const Document before = besideBystander(smoothBezierSpline());
    const Document closed = setClosed(before, 0, true);
    expectPlausible(before, closed, "closed");
    EXPECT_EQ(piecesOf(firstOf(closed)).size(), 3u);
    EXPECT_EQ(setClosed(closed, 0, false), before);
    EXPECT_EQ(setClosed(closed, 0, true), closed) << "closing twice is closing";
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

TEST(MovePoints, leavesFourteenDigits) {
    // As read back from their decimals, of sums of any size.
    std::mt19937_64 engine(4);
    const auto random = [&] { return static_cast<double>(engine() >> 11) * 0x1p-53 - 0.5; };
    for (int k = 0; k < 20'000; ++k) {
        const double size = std::pow(10.0, static_cast<int>(engine() % 26) - 16);
        const double a = k % 3 == 0 ? std::round(1e5 * random()) / 1e3 : size * random();
        const double b = k % 3 == 0 ? std::round(1e5 * random()) / 1e3 : size * random();
        Curve curve = planeCurve("cardinal", 4);
        curve.points.set(0, {a, 1});
        const Document after =
            movePoints(besideBystander(curve), std::vector<PointId>{{0, 0}}, {b, 0});
        std::array<char, 40> text{};
        std::snprintf(text.data(), text.size(), "%.13e", a + b);
        EXPECT_EQ(after.curves[0]->points[0][0], b == 0 ? a : std::strtod(text.data(), nullptr))
            << text.data();
    }
}

} // namespace
} // namespace splineloft
