// Numbers typed into fields of the inspector: exact, worked out, refused in words, never lost.
#include "driver.h"
#include "hand.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace splineloft::ui {
namespace {

TEST(NumberFields, aNumberIsTakenExactlyAsTyped) {
    for (const Key with : {Key::enter, Key::keypadEnter, Key::tab}) {
        Driver driver(documentOf({curveOf("cardinal")}));
        driver.enter(sliderField("tension"), "0.1234567890123", with);
        EXPECT_EQ(driver.curve().parameters.at("tension"), 0.1234567890123)
            << static_cast<int>(with);
        EXPECT_EQ(driver.steps(), 1);
    }
}

TEST(NumberFields, aNumberMayBeWorkedOut) {
    Driver driver(documentOf({curveOf("cardinal")}));
    driver.enter(pointField(2, 0), "3+0.1");
    EXPECT_EQ(driver.curve().points.at(2)[0], 3.1);
    EXPECT_EQ(driver.steps(), 1);
}

TEST(NumberFields, aSelectionIsMovedScaledAndTurnedByNumbers) {
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

TEST(NumberFields, aClickElsewhereTakesTheNumberToo) {
    Driver driver(documentOf({curveOf("cardinal")}));
    driver.click(sliderField("tension"));
    driver.type("0.75");
    driver.click(driver.at({-0.5, -1.75}));
    EXPECT_EQ(driver.curve().parameters.at("tension"), 0.75);
    EXPECT_EQ(driver.steps(), 1);
}

TEST(NumberFields, escapeInAFieldForgetsWhatWasTyped) {
    Driver driver(documentOf({curveOf("cardinal")}));
    driver.session.view.selection = {{0, 2}};
    driver.enter(pointField(1, 0), "7", Key::escape);
    driver.frames(3);
    EXPECT_EQ(driver.curve().points, sevenPoints());
    EXPECT_EQ(driver.steps(), 0);
}

TEST(NumberFields, aNumberOutOfRangeIsRefusedInWords) {
    Driver driver(documentOf({curveOf("cardinal")}));
    const auto& tension = familyOf(driver.curve()).parameters.front();
    driver.enter(sliderField("tension"), std::to_string(tension.most + 1));
    EXPECT_EQ(driver.curve().parameters.at("tension"), 0.5);
    EXPECT_EQ(driver.steps(), 0);
    ASSERT_TRUE(driver.session.notice);
    EXPECT_TRUE(driver.session.notice->isProblem);
    EXPECT_NE(driver.session.notice->text.find("right would be"), std::string::npos)
        << driver.session.notice->text;
    driver.enter(pointField(0, 1), "2e9");
    EXPECT_EQ(driver.curve().points, sevenPoints());
    EXPECT_TRUE(driver.session.notice);
}

TEST(NumberFields, ofASelectionTooWhatIsNoNumberIsRefusedInWords) {
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

TEST(NumberFields, whatIsNoNumberIsLeftAlone) {
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

TEST(NumberFields, thePointsTableSetsCoordinates) {
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

TEST(NumberFields, tabGoesOnToTheNextNumber) {
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

TEST(NumberFields, aNumberThatIsOnlyLookedAtStaysAsItIs) {
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

TEST(NumberFields, whatWasTypedGoesToTheCurveForWhichItWasTyped) {
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

TEST(NumberFields, whatWasTypedIsNotLostToThePen) {
    Driver driver(documentOf({curveOf("cardinal")}));
    driver.key(Key::p);
    driver.click(pointField(2, 0));
    driver.type("0.75");
    driver.click(driver.at({-0.5, -1.75}));
    EXPECT_EQ(driver.curve().points.at(2), (Point{0.75, -0.5}));
    EXPECT_EQ(driver.curve().points.size(), 8U) << "and the point is put down";
    EXPECT_EQ(driver.steps(), 2);
}

TEST(NumberFields, whatWasTypedGoesToItsPointThoughAnotherIsInsertedBefore) {
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

} // namespace
} // namespace splineloft::ui
