// The inspector and the strip of plots, worked with real events: what a person turns, types and
// clicks there, and how many steps it leaves.
#include "driver.h"
#include "hand.h"

#include "core/spline/catalog.h"

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
