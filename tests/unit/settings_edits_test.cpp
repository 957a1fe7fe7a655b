// Edits of what a curve is rather than where: its family, ends, knots, weights and parameters.
#include "core/document/edits.h"

#include "tests/unit/edited_curves.h"

namespace splineloft {
namespace {

using namespace testing_curves;

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

} // namespace
} // namespace splineloft
