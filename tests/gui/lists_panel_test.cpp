// What the inspector shows and edits beside coordinates: weights, parameters with a value at each
// point, and knots of one's own.
#include "driver.h"
#include "hand.h"

#include "core/document/edits.h"
#include "core/spline/catalog.h"

#include <gtest/gtest.h>

namespace splineloft::ui {
namespace {

using Numbers = std::vector<double>;

/// The column after the two coordinates, and the one after that.
constexpr int firstList = 2;
constexpr int secondList = 3;

Widget perPoint(const std::string& key) {
    return inInspector("###per " + key);
}

Curve ownKnots(bool closed = false) {
    Curve curve = curveOf("nurbs", closed);
    curve.parameters["degree"] = 2;
    curve.knots = closed ? Numbers{0, 1, 2, 4, 5, 6, 8, 9} : Numbers{0, 0, 0, 1, 2, 4, 5, 6, 6, 6};
    curve.ends = Ends::none;
    return curve;
}

TEST(WeightColumn, showsOneUntilAWeightIsEntered) {
    Driver driver(documentOf({curveOf("nurbs")}));
    driver.enter(pointField(2, firstList), "4");
    EXPECT_EQ(driver.curve().weights, (Numbers{1, 1, 4, 1, 1, 1, 1}));
    EXPECT_EQ(driver.session.history.undoLabel(), "Set weight of P₂");
    driver.enter(pointField(5, firstList), "1/4");
    EXPECT_EQ(driver.curve().weights, (Numbers{1, 1, 4, 1, 1, 0.25, 1}));
    EXPECT_EQ(driver.steps(), 2);
    driver.key(Key::z, withControl);
    driver.key(Key::z, withControl);
    EXPECT_EQ(driver.curve(), curveOf("nurbs"));
    EXPECT_EQ(driver.faults(), "");
}

TEST(WeightColumn, refusesWhatIsNoWeight) {
    for (const std::string text : {"0", "-2", "1e10", "heavy"}) {
        Driver driver(documentOf({curveOf("nurbs")}));
        driver.enter(pointField(1, firstList), text);
        EXPECT_TRUE(driver.curve().weights.empty()) << text;
        EXPECT_EQ(driver.steps(), 0) << text;
        ASSERT_TRUE(driver.session.notice) << text;
        EXPECT_TRUE(driver.session.notice->isProblem) << text;
    }
}

TEST(WeightColumn, isThereForFamiliesWithWeightsOnly) {
    for (const auto& family : catalog()) {
        Driver driver(documentOf({curveOf(family.id)}));
        EXPECT_EQ(driver.has(pointField(0, firstList)), family.usesWeights) << family.id;
    }
}

TEST(PerPoint, givesASliderForEachPointAndTakesItAway) {
    Driver driver(documentOf({curveOf("cardinal")}));
    EXPECT_FALSE(driver.has(pointField(0, firstList)));
    driver.click(perPoint("tension"));
    EXPECT_EQ(driver.curve().local.at("tension"), Numbers(7, 0.5));
    EXPECT_EQ(driver.session.history.undoLabel(), "Tension per point");
    driver.enter(pointField(3, firstList), "0.875");
    EXPECT_EQ(driver.curve().local.at("tension").at(3), 0.875);
    EXPECT_EQ(driver.session.history.undoLabel(), "Set Tension of P₃");
    driver.click(perPoint("tension"));
    EXPECT_EQ(driver.curve(), curveOf("cardinal"));
    EXPECT_EQ(driver.session.history.undoLabel(), "Tension for the whole curve");
    EXPECT_EQ(driver.steps(), 3);
}

TEST(PerPoint, theSliderSetsTheSelectedPointsOrAll) {
    Driver driver(makeLocal(documentOf({curveOf("beta")}), 0, "tension"));
    driver.session.view.selection = {{0, 2}, {0, 4}};
    driver.enter(sliderField("tension"), "20");
    EXPECT_EQ(driver.curve().local.at("tension"), (Numbers{0, 0, 20, 0, 20, 0, 0}));
    EXPECT_EQ(driver.session.history.undoLabel(), "Set Tension of 2 points");
    EXPECT_EQ(driver.curve().parameters.at("tension"), 0) << "the curve's own is left alone";
    driver.session.view.selection = {};
    driver.enter(sliderField("tension"), "3");
    EXPECT_EQ(driver.curve().local.at("tension"), Numbers(7, 3));
    EXPECT_EQ(driver.session.history.undoLabel(), "Set Tension of all points");
    EXPECT_EQ(driver.steps(), 2);
}

TEST(PerPoint, valuesThatDifferAreNotShownAsOne) {
    Driver driver(makeLocal(documentOf({curveOf("beta")}), 0, "tension"));
    // Its words can be told by their width.
    const auto width = [&] { return driver.find(inInspector("###per tension"))->width; };
    const double allAlike = width();
    driver.session.view.selection = {{0, 2}};
    driver.enter(sliderField("tension"), "20");
    driver.session.view.selection = {};
    EXPECT_GT(width(), allAlike) << "mixed values";
    driver.enter(sliderField("tension"), "3");
    EXPECT_EQ(width(), allAlike);
}

TEST(PerPoint, aSlideIsOneStepAndEscapeRestores) {
    const Document document = makeLocal(documentOf({curveOf("kochanek-bartels")}), 0, "bias");
    Driver driver(document);
    driver.session.view.selection = {{0, 3}};
    const auto track = *driver.find(slider("bias"));
    const double y = track.top + track.height / 2;
    driver.press({track.left + 0.8 * track.width, y});
    EXPECT_GT(driver.curve().local.at("bias").at(3), 0.4);
    EXPECT_EQ(driver.curve().local.at("bias").at(2), 0);
    EXPECT_EQ(driver.steps(), 0);
    driver.key(Key::escape);
    EXPECT_EQ(driver.session.document(), document);
    driver.release();
    driver.drag({track.left + 0.5 * track.width, y}, {track.left + 0.9 * track.width, y});
    EXPECT_EQ(driver.steps(), 1);
    EXPECT_EQ(driver.session.history.undoLabel(), "Set Bias of P₃");
    EXPECT_EQ(driver.faults(), "");
}

TEST(PerPoint, isOfferedWhereTheFamilyAllowsIt) {
    for (const auto& family : catalog()) {
        Driver driver(documentOf({curveOf(family.id)}));
        for (const auto& parameter : family.parameters) {
            EXPECT_EQ(driver.has(perPoint(std::string(parameter.key))), parameter.local)
                << family.id << ' ' << parameter.key;
        }
    }
}

TEST(PerPoint, severalParametersHaveAColumnEach) {
    Driver driver(documentOf({curveOf("kochanek-bartels")}));
    driver.click(perPoint("continuity"));
    driver.click(perPoint("tension"));
    driver.enter(pointField(1, firstList), "0.25"); // in the order of the sliders
    driver.enter(pointField(1, secondList), "-0.75");
    EXPECT_EQ(driver.curve().local.at("tension").at(1), 0.25);
    EXPECT_EQ(driver.curve().local.at("continuity").at(1), -0.75);
}

TEST(PerPoint, aNewPointGetsItsShare) {
    Driver driver(makeLocal(documentOf({curveOf("cardinal")}), 0, "tension"));
    driver.enter(pointField(2, firstList), "1");
    const Point p = driver.session.active()->pieces().position({2, 0.5});
    driver.doubleClick(driver.at({p[0], p[1]}));
    EXPECT_EQ(driver.curve().local.at("tension"), (Numbers{0.5, 0.5, 1, 0.75, 0.5, 0.5, 0.5, 0.5}));
    EXPECT_EQ(driver.faults(), "");
}

TEST(OwnKnots, giveWayToAnotherEnd) {
    Driver driver(documentOf({ownKnots()}));
    driver.click(Widget{"inspector", {"ends", "clamped"}});
    EXPECT_TRUE(driver.curve().knots.empty());
    EXPECT_EQ(driver.curve().ends, Ends::clamped);
    EXPECT_EQ(driver.steps(), 1);
    driver.key(Key::z, withControl);
    EXPECT_EQ(driver.curve(), ownKnots());
}

TEST(OwnKnots, ofAClosedCurveCanBeDropped) {
    Driver driver(documentOf({ownKnots(true)}));
    driver.click(inInspector("drop"));
    EXPECT_TRUE(driver.curve().knots.empty());
    EXPECT_TRUE(driver.curve().closed);
    EXPECT_EQ(driver.faults(), "");
    EXPECT_FALSE(driver.has(inInspector("drop")));
    driver.key(Key::z, withControl);
    EXPECT_EQ(driver.curve(), ownKnots(true));
}

TEST(OwnKnots, surviveADegreeThatWasOnlyPassed) {
    Driver driver(documentOf({ownKnots()}));
    const auto track = *driver.find(slider("degree"));
    const double y = track.top + track.height / 2;
    const double two = track.left + track.width / 6; // of the range 1 to 7
    driver.press({track.left + track.width / 2, y});
    EXPECT_TRUE(driver.curve().knots.empty());
    driver.move({two, y});
    driver.release();
    EXPECT_EQ(driver.curve(), ownKnots()) << "the slide counts from where it began";
    EXPECT_EQ(driver.steps(), 0);
}

TEST(Nurbs, isChosenWithItsPointsAndClampedEnds) {
    Driver driver(documentOf({curveOf("cardinal")}));
    driver.click(inInspector("##family"));
    driver.click(driver.option("NURBS"));
    EXPECT_EQ(driver.curve().family, "nurbs");
    EXPECT_EQ(driver.curve().points, sevenPoints());
    EXPECT_EQ(driver.curve().ends, Ends::clamped);
    EXPECT_EQ(driver.faults(), "");
}

TEST(ManyWeightedPoints, areStudiedOnTheFirst) {
    for (const bool closed : {false, true}) {
        Curve curve = ownKnots();
        curve.closed = closed;
        curve.knots.assign(closed ? 1 : 3, 0.0);
        curve.points = Points(2);
        for (int i = 0; i < 400; ++i) {
            curve.points.append({0.5 * i, i % 3 - 1.0});
            curve.weights.push_back(1 + i % 5);
            curve.knots.push_back(i / 2 + 1);
        }
        ASSERT_FALSE(problemOf(curve)) << problemOf(curve)->what;
        Driver driver(documentOf({curve}));
        EXPECT_EQ(driver.faults(), "");
        EXPECT_TRUE(driver.session.active()->traits().inHull);
    }
    Curve shaped = curveOf("beta");
    shaped.points = Points(2);
    for (int i = 0; i < 300; ++i) {
        shaped.points.append({0.5 * i, i % 3 - 1.0});
        shaped.local["tension"].push_back(i % 7);
    }
    Driver driver(documentOf({shaped}));
    EXPECT_EQ(driver.faults(), "");
}

} // namespace
} // namespace splineloft::ui
