// The inspector and the strip of plots, worked with real events: what a person turns, types and
// clicks there, and how many steps it leaves.
#include "driver.h"
#include "hand.h"

#include "core/spline/catalog.h"
#include "ui/refusal.h"

#include <gtest/gtest.h>

#include <cmath>

namespace splineloft::ui {
namespace {

double parameter(const Driver& driver, const std::string& key) {
    return driver.curve().parameters.at(key);
}

ScreenPoint along(const ScreenRect& track, double part) {
    return {track.left + part * track.width, track.top + track.height / 2};
}

TEST(Panels, theFamilyListSwitchesTheFamily) {
    Driver driver(documentOf({curveOf("cardinal")}));
    driver.click(inInspector("##family"));
    driver.click(driver.option("B-spline"));
    EXPECT_EQ(driver.curve().family, "b-spline");
    EXPECT_EQ(driver.curve().points, sevenPoints());
    EXPECT_EQ(driver.steps(), 1);
    EXPECT_EQ(driver.session.history.undoLabel(), "Draw as B-spline");
    driver.key(Key::z, withControl);
    EXPECT_EQ(driver.curve(), curveOf("cardinal"));
}

TEST(Panels, aSliderPreviewsWhileItIsDraggedAndLeavesOneStep) {
    Driver driver(documentOf({curveOf("cardinal")}));
    const auto track = *driver.find(slider("tension"));
    driver.press(along(track, 0.7));
    const double first = parameter(driver, "tension");
    EXPECT_TRUE(driver.session.history.previewing());
    driver.move(along(track, 0.2));
    EXPECT_LT(parameter(driver, "tension"), first);
    EXPECT_EQ(driver.steps(), 0) << "nothing is settled yet";
    driver.release();
    EXPECT_EQ(driver.steps(), 1);
    EXPECT_FALSE(driver.session.history.previewing());
    EXPECT_EQ(driver.session.history.undoLabel(), "Set Tension");
    driver.frames(5);
    EXPECT_EQ(driver.steps(), 1);
}

TEST(Panels, escapeInMidSlideRestores) {
    Driver driver(documentOf({curveOf("cardinal")}));
    driver.session.view.selection = {{0, 2}};
    const auto track = *driver.find(slider("tension"));
    driver.press(along(track, 0.9));
    ASSERT_NE(parameter(driver, "tension"), 0.5);
    driver.key(Key::escape);
    EXPECT_EQ(parameter(driver, "tension"), 0.5);
    driver.move(along(track, 0.1));
    driver.release();
    EXPECT_EQ(parameter(driver, "tension"), 0.5) << "the slide is over";
    EXPECT_EQ(driver.steps(), 0);
    EXPECT_EQ(driver.session.view.selection.size(), 1U) << "Escape meant the slider alone";
}

TEST(Panels, theKnobOfASliderStaysBelowThePointerThatHoldsIt) {
    Driver driver(documentOf({curveOf("cardinal")}));
    const auto track = *driver.find(slider("tension"));
    driver.drag(along(track, 0.1), along(track, 0.7));
    const double before = parameter(driver, "tension");
    const auto beside = [&track](double part) {
        return ScreenPoint{along(track, part).x + 5, along(track, part).y};
    };
    driver.click(beside(0.7));
    EXPECT_EQ(parameter(driver, "tension"), before) << "a click on it moves nothing";
    EXPECT_EQ(driver.steps(), 1);
    driver.doubleClick(beside(0.7));
    EXPECT_EQ(parameter(driver, "tension"), 0.5);
    EXPECT_EQ(driver.steps(), 2) << "a double click on it is one step";
    driver.key(Key::z, withControl);
    EXPECT_EQ(parameter(driver, "tension"), before);

    driver.drag(beside(0.7), beside(0.3));
    const double held = parameter(driver, "tension");
    driver.drag(along(track, 0.9), along(track, 0.3));
    EXPECT_NEAR(held, parameter(driver, "tension"), 0.002) << "of 2, on some 280 pixels";
}

TEST(Panels, aDoubleClickOnASliderReturnsToTheNeutralValue) {
    Driver driver(documentOf({curveOf("cardinal")}));
    const auto track = *driver.find(slider("tension"));
    driver.drag(along(track, 0.5), along(track, 0.95));
    ASSERT_NE(parameter(driver, "tension"), 0.5);
    driver.doubleClick(along(track, 0.3));
    EXPECT_EQ(parameter(driver, "tension"), 0.5);
    driver.frames(3);
    EXPECT_EQ(parameter(driver, "tension"), 0.5);
}

TEST(Panels, aRatioSlidesLogarithmically) {
    Driver driver(documentOf({curveOf("beta")}));
    const auto& bias = familyOf(driver.curve()).parameters.front();
    ASSERT_EQ(bias.scale, Scale::ratio);
    const auto track = *driver.find(slider(std::string(bias.key)));
    std::vector<double> values;
    for (const double part : {0.2, 0.4, 0.6, 0.8}) {
        driver.drag(along(track, 0.1), along(track, part));
        values.push_back(parameter(driver, std::string(bias.key)));
    }
    const double ratio = std::pow(bias.sliderMost / bias.sliderLeast, 0.2);
    for (std::size_t i = 0; i + 1 < values.size(); ++i) {
        EXPECT_NEAR(values[i + 1] / values[i], ratio, 0.02 * ratio) << "equal ways, equal ratios";
    }
}

TEST(Panels, everySliderOfEveryFamilyEndsWhereItSays) {
    for (const auto& family : catalog()) {
        Driver driver(documentOf({curveOf(family.id)}));
        for (const auto& p : family.parameters) {
            const std::string key(p.key);
            const auto track = *driver.find(slider(key));
            driver.drag(along(track, 0.5), {track.right() + 300, track.top + 5});
            EXPECT_EQ(parameter(driver, key), p.sliderMost) << family.id << " " << key;
            driver.drag(along(track, 0.5), {track.left - 300, track.top + 5});
            EXPECT_EQ(parameter(driver, key), p.sliderLeast) << family.id << " " << key;
            EXPECT_EQ(driver.faults(), "") << family.id << " " << key;
        }
    }
}

TEST(Panels, aNumberIsTakenExactlyAsTyped) {
    for (const Key with : {Key::enter, Key::keypadEnter, Key::tab}) {
        Driver driver(documentOf({curveOf("cardinal")}));
        driver.enter(sliderField("tension"), "0.1234567890123", with);
        EXPECT_EQ(parameter(driver, "tension"), 0.1234567890123) << static_cast<int>(with);
        EXPECT_EQ(driver.steps(), 1);
    }
}

TEST(Panels, aNumberMayBeWorkedOut) {
    Driver driver(documentOf({curveOf("cardinal")}));
    driver.enter(pointField(2, 0), "3+0.1");
    EXPECT_EQ(driver.curve().points.at(2)[0], 3.1);
    EXPECT_EQ(driver.steps(), 1);
}

TEST(Panels, aSelectionIsMovedScaledAndTurnedByNumbers) {
    struct Case {
        const char* label;
        const char* number;
        std::array<double, 4> box; // left, right, bottom, top afterwards
    };
    // A box from -3 to 1 and from 0 to 2: about its middle (-1, 1).
    const Points square = {{9, 9}, {-3, 0}, {1, 0}, {1, 2}, {-3, 2}, {7, -8}};
    for (const auto& [label, number, box] :
         {Case{"x", "4", {2, 6, 0, 2}}, Case{"y", "1 - 6", {-3, 1, -6, -4}},
          Case{"width", "2*3", {-4, 2, 0, 2}}, Case{"height", "1", {-3, 1, 0.5, 1.5}},
          Case{"turn \u00B0", "90", {-2, 0, -1, 3}}, Case{"scale %", "50", {-2, 0, 0.5, 1.5}}}) {
        Curve curve = curveOf("linear");
        curve.points = square;
        Driver driver(documentOf({curve}));
        driver.settle();
        driver.session.view.selection = {{0, 1}, {0, 2}, {0, 3}, {0, 4}};
        driver.settle();
        driver.enter({"selection", {label, "##selection"}}, number);
        const Points after = driver.curve().points;
        double left = 1e9, right = -1e9, bottom = 1e9, top = -1e9;
        for (const std::size_t i : {1, 2, 3, 4}) {
            left = std::min(left, after.at(i)[0]);
            right = std::max(right, after.at(i)[0]);
            bottom = std::min(bottom, after.at(i)[1]);
            top = std::max(top, after.at(i)[1]);
        }
        EXPECT_NEAR(left, box[0], 1e-12) << label;
        EXPECT_NEAR(right, box[1], 1e-12) << label;
        EXPECT_NEAR(bottom, box[2], 1e-12) << label;
        EXPECT_NEAR(top, box[3], 1e-12) << label;
        EXPECT_EQ(after.at(0), square.at(0)) << label << ": others stay";
        EXPECT_EQ(after.at(5), square.at(5)) << label << ": others stay";
        EXPECT_EQ(driver.steps(), 1) << label;
    }
}

TEST(Panels, aClickElsewhereTakesTheNumberToo) {
    Driver driver(documentOf({curveOf("cardinal")}));
    driver.click(sliderField("tension"));
    driver.type("0.75");
    driver.click(driver.at({-0.5, -1.75}));
    EXPECT_EQ(parameter(driver, "tension"), 0.75);
    EXPECT_EQ(driver.steps(), 1);
}

TEST(Panels, escapeInAFieldForgetsWhatWasTyped) {
    Driver driver(documentOf({curveOf("cardinal")}));
    driver.session.view.selection = {{0, 2}};
    driver.enter(pointField(1, 0), "7", Key::escape);
    driver.frames(3);
    EXPECT_EQ(driver.curve().points, sevenPoints());
    EXPECT_EQ(driver.steps(), 0);
}

TEST(Panels, aNumberOutOfRangeIsRefusedInWords) {
    Driver driver(documentOf({curveOf("cardinal")}));
    const auto& tension = familyOf(driver.curve()).parameters.front();
    driver.enter(sliderField("tension"), std::to_string(tension.most + 1));
    EXPECT_EQ(parameter(driver, "tension"), 0.5);
    EXPECT_EQ(driver.steps(), 0);
    ASSERT_TRUE(driver.session.notice);
    EXPECT_TRUE(driver.session.notice->isProblem);
    EXPECT_NE(driver.session.notice->text.find("right would be"), std::string::npos)
        << driver.session.notice->text;
    driver.enter(pointField(0, 1), "2e9");
    EXPECT_EQ(driver.curve().points, sevenPoints());
    EXPECT_TRUE(driver.session.notice);
}

TEST(Panels, refusalsNameThePlaceAsTheWindowDoes) {
    Curve curve = curveOf("hermite");
    curve.coordinates = {"x", "height"};
    const Document document = documentOf({curve, curveOf("kochanek-bartels")});
    const auto place = [&](const char* pointer) {
        const auto words = refusalOf("Set it", {pointer, "|", ""}, document);
        return words.substr(0, words.find(" |"));
    };
    const std::string refused = "Set it is not possible: ";
    EXPECT_EQ(place("/curves/0/points/2/1"), refused + "height of P₂");
    EXPECT_EQ(place("/curves/0/points/2"), refused + "P₂");
    EXPECT_EQ(place("/curves/0/points"), refused + "points");
    EXPECT_EQ(place("/curves/0/tangents/1/0"), refused + "x of the tangent at P₁");
    EXPECT_EQ(place("/curves/1/parameters/tension"), refused + "Tension");
    EXPECT_EQ(place("/curves/1/local/tension/6"), refused + "Tension of P₆");
    EXPECT_EQ(place("/curves/1/weights/3"), refused + "weight of P₃");
    EXPECT_EQ(place("/curves/1/knots/3"), refused + "knots");
    EXPECT_EQ(place("/curves/1/family"), refused + "family");
    EXPECT_EQ(place("/curves/7/points"), refused + "/curves/7/points") << "there is no such curve";
    EXPECT_EQ(place("/curves/0/points/70"), refused + "points");
}

TEST(Panels, ofASelectionTooWhatIsNoNumberIsRefusedInWords) {
    Driver driver(documentOf({curveOf("cardinal")}));
    driver.session.view.selection = {{0, 1}, {0, 2}};
    driver.frames(2);
    driver.enter({"selection", {"width", "##selection"}}, "1/0");
    EXPECT_EQ(driver.curve().points, sevenPoints());
    ASSERT_TRUE(driver.session.notice);
    EXPECT_EQ(driver.session.notice->text,
              "Scale 2 points is not possible: x of P₁ is not a finite number; right would be: a "
              "finite number");
}

TEST(Panels, whatIsNoNumberIsLeftAlone) {
    for (const std::string text : {"", "-", "1e", "e5", "..", "1e999", "1+", "(2", "1/0"}) {
        Driver driver(documentOf({curveOf("cardinal")}));
        driver.click(pointField(0, 0));
        driver.key(Key::a, withControl);
        driver.key(Key::del);
        driver.type(text);
        driver.key(Key::enter);
        EXPECT_EQ(driver.faults(), "");
        EXPECT_EQ(driver.curve().points, sevenPoints()) << "typed “" << text << "”";
    }
}

TEST(Panels, thePointsTableSetsCoordinates) {
    Driver driver(documentOf({curveOf("hermite")}));
    driver.enter(pointField(3, 0), "-2.5");
    EXPECT_EQ(driver.curve().points.at(3), (Point{-2.5, 1.125}));
    EXPECT_EQ(driver.session.history.undoLabel(), "Set x of P₃");
    driver.enter(pointField(3, 1), "1e3");
    EXPECT_EQ(driver.curve().points.at(3), (Point{-2.5, 1000}));
    driver.enter(tangentField(6, 1), "+4");
    EXPECT_EQ(driver.curve().tangents.at(6)[1], 4);
    EXPECT_EQ(driver.steps(), 3);
}

TEST(Panels, tabGoesOnToTheNextNumber) {
    Driver driver(documentOf({curveOf("cardinal")}));
    driver.click(pointField(2, 0));
    driver.type("11");
    driver.key(Key::tab);
    driver.type("12");
    driver.key(Key::tab);
    driver.type("13");
    driver.key(Key::enter);
    EXPECT_EQ(driver.curve().points.at(2), (Point{11, 12}));
    EXPECT_EQ(driver.curve().points.at(3)[0], 13);
    EXPECT_EQ(driver.steps(), 3);
}

TEST(Panels, aNumberThatIsOnlyLookedAtStaysAsItIs) {
    Curve crooked = curveOf("cardinal");
    crooked.points.set(2, {1.0 / 3, std::sqrt(2.0) * 1e-5});
    Driver driver(documentOf({crooked}));
    for (const Key with : {Key::enter, Key::tab, Key::escape}) {
        driver.click(pointField(2, 0));
        driver.key(with);
        driver.click(pointField(2, 1));
        driver.key(with);
        EXPECT_EQ(driver.steps(), 0) << static_cast<int>(with);
    }
    driver.click(driver.at({-0.5, -1.75}));
    EXPECT_EQ(driver.curve(), crooked) << "to the last bit";
    EXPECT_EQ(driver.steps(), 0);
}

TEST(Panels, theRowsSelect) {
    Driver driver(documentOf({curveOf("cardinal")}));
    driver.click(pointRow(4));
    EXPECT_EQ(driver.session.view.selection, (Selection{{0, 4}}));
    driver.hold(Key::leftShift);
    const ScreenPoint before = driver.middle(pointRow(0));
    driver.click(pointRow(1));
    driver.frames(2);
    EXPECT_EQ(driver.middle(pointRow(0)).y, before.y) << "the numbers of both push no row away";
    EXPECT_EQ(driver.session.view.selection, (Selection{{0, 1}, {0, 4}}));
    driver.click(pointRow(4));
    EXPECT_EQ(driver.session.view.selection, (Selection{{0, 1}})) << "taken away again";
    driver.letGo(Key::leftShift);
}

TEST(Panels, theEndsAreChosenByButtons) {
    Driver driver(documentOf({curveOf("b-spline")}));
    for (const auto ends : familyOf(driver.curve()).ends) {
        driver.click(Widget{"inspector", {"ends", std::string(nameOf(ends))}});
        EXPECT_EQ(driver.curve().ends, ends) << nameOf(ends);
    }
    EXPECT_EQ(driver.steps(), static_cast<int>(familyOf(driver.curve()).ends.size()) - 1);
}

TEST(Panels, theCheckboxCloses) {
    for (const auto& family : catalog()) {
        Driver driver(documentOf({curveOf(family.id)}));
        ASSERT_EQ(driver.has(inInspector("Closed")), family.closable) << family.id;
        if (family.closable) {
            driver.click(inInspector("Closed"));
            EXPECT_TRUE(driver.curve().closed) << family.id;
            driver.click(inInspector("Closed"));
            EXPECT_EQ(driver.curve(), curveOf(family.id)) << "open again as it was";
            EXPECT_EQ(driver.steps(), 2) << family.id;
        }
    }
}

TEST(Panels, whatWasTypedGoesToTheCurveForWhichItWasTyped) {
    Curve other = curveOf("cardinal");
    other.points = {{-3, 3}, {-2.5, 2.5}, {-2, 3}};
    Driver driver(documentOf({curveOf("cardinal"), other}));
    driver.click(pointField(2, 0));
    driver.type("9");
    driver.click(driver.at({-2, 3})); // a point of the other curve
    EXPECT_EQ(driver.session.view.activeCurve, 1U);
    EXPECT_EQ(driver.session.document().curves[0]->points.at(2), (Point{9, -0.5}));
    EXPECT_EQ(driver.session.document().curves[1]->points, other.points);
}

TEST(Panels, whatWasTypedIsNotLostToThePen) {
    Driver driver(documentOf({curveOf("cardinal")}));
    driver.key(Key::p);
    driver.click(pointField(2, 0));
    driver.type("0.75");
    driver.click(driver.at({-0.5, -1.75}));
    EXPECT_EQ(driver.curve().points.at(2), (Point{0.75, -0.5}));
    EXPECT_EQ(driver.curve().points.size(), 8U) << "and the point is put down";
    EXPECT_EQ(driver.steps(), 2);
}

TEST(Panels, whatWasTypedGoesToItsPointThoughAnotherIsInsertedBefore) {
    Driver driver(documentOf({curveOf("cardinal")}));
    driver.click(pointField(5, 0));
    driver.type("4");
    const Point p = driver.session.active()->pieces().position({1, 0.5});
    driver.hold(Key::leftControl);
    driver.click(driver.at({p[0], p[1]}));
    driver.letGo(Key::leftControl);
    ASSERT_EQ(driver.curve().points.size(), 8U);
    EXPECT_EQ(driver.curve().points.at(6), (Point{4, 1.75}));
    EXPECT_EQ(driver.curve().points.at(5), sevenPoints().at(4));
}

TEST(Panels, aDragOnThePlotMovesU) {
    Driver driver(documentOf({curveOf("cardinal")}));
    for (const char* plot : {"whole", "segments"}) {
        const auto rect = *driver.find(Widget{"strip", {plot}});
        driver.press(along(rect, 0.25));
        const Spot before = driver.session.view.cursor;
        driver.move(along(rect, 0.75));
        EXPECT_NE(driver.session.view.cursor, before) << plot;
        driver.move({rect.right() + 500, rect.top});
        EXPECT_EQ(driver.session.view.cursor.u, 1) << plot << ": held at the end";
        driver.release();
        const Spot last = driver.session.view.cursor;
        driver.move(along(rect, 0.5));
        EXPECT_EQ(driver.session.view.cursor, last) << plot << ": let go";
    }
    EXPECT_EQ(driver.steps(), 0);
}

TEST(Panels, theCurveListTurnsToACurve) {
    Curve other = curveOf("linear");
    other.points = {{1, 1}};
    Driver driver(documentOf({curveOf("b-spline"), other}));
    driver.session.view.cursor = {5, 0.5};
    driver.click(Widget{"inspector", {"curves", 1, "##name"}});
    EXPECT_EQ(driver.session.view.activeCurve, 1U);
    EXPECT_EQ(driver.faults(), "");
    driver.click(Widget{"inspector", {"curves", 0, "##name"}});
    EXPECT_EQ(driver.session.view.activeCurve, 0U);
}

TEST(Panels, theCanvasShowsTheChosenCoordinates) {
    Driver driver(documentOf({curveOf("cardinal", 6)}));
    driver.click(inInspector("up"));
    driver.click(driver.option("c4"));
    EXPECT_EQ(driver.session.view.axes, (Axes{0, 4}));
    EXPECT_EQ(driver.steps(), 0);
}

} // namespace
} // namespace splineloft::ui
