// Selecting with clicks and boxes, and what lies on top where points are stacked.
#include "hand.h"

#include <gtest/gtest.h>

namespace splineloft::ui {
namespace {

constexpr PlanePoint nowhere{-0.5, -2.9};

Hand handOnCardinal() {
    return Hand(documentOf({curveOf("cardinal")}));
}

TEST(SelectGesture, ofPointsOnOneAnotherTheOneThatIsSeenIsTaken) {
    Curve curve = curveOf("linear");
    curve.points.set(5, curve.points.at(2));
    Hand hand(documentOf({curve, curve}));
    hand.click(hand.place(2));
    EXPECT_EQ(hand.session.view.selection, (Selection{{0, 5}})) << "of the active curve the last";
    hand.session.view.selection.clear();
    hand.session.view.activeCurve = 1;
    hand.click(hand.place(2));
    EXPECT_EQ(hand.session.view.selection, (Selection{{1, 5}}));
}

TEST(SelectGesture, aClickSelectsThisPointAlone) {
    Hand hand = handOnCardinal();
    for (std::size_t i = 0; i < 7; ++i) {
        hand.click(hand.place(i));
        EXPECT_EQ(hand.session.view.selection, (Selection{{0, i}})) << "P" << i;
    }
    hand.click(nowhere);
    EXPECT_TRUE(hand.session.view.selection.empty()) << "a click beside everything clears it";
    EXPECT_EQ(hand.steps(), 0) << "selecting is no edit";
}

TEST(SelectGesture, shiftAddsAndTakesAway) {
    Hand hand = handOnCardinal();
    hand.click(hand.place(1));
    hand.click(hand.place(4), withShift);
    EXPECT_EQ(hand.session.view.selection, (Selection{{0, 1}, {0, 4}}));
    hand.click(hand.place(1), withShift);
    EXPECT_EQ(hand.session.view.selection, (Selection{{0, 4}}));
    hand.click(nowhere, withShift);
    EXPECT_EQ(hand.session.view.selection, (Selection{{0, 4}})) << "Shift on nothing takes nothing";
}

TEST(SelectGesture, aClickOnOneOfManyLeavesThatOne) {
    Hand hand = handOnCardinal();
    hand.key(Key::a, withControl);
    ASSERT_EQ(hand.session.view.selection.size(), 7U);
    hand.press(hand.place(3));
    EXPECT_EQ(hand.session.view.selection.size(), 7U) << "it may yet become a drag of all";
    hand.release(hand.place(3));
    EXPECT_EQ(hand.session.view.selection, (Selection{{0, 3}}));
}

TEST(SelectGesture, aDragOnNothingBoxes) {
    Hand hand = handOnCardinal();
    hand.drag({-3.9, 2.25}, {-1.5, -1.5});
    EXPECT_EQ(hand.session.view.selection, (Selection{{0, 0}, {0, 1}}));
    hand.drag({3.4, -2}, {2.6, 0}, withShift);
    EXPECT_EQ(hand.session.view.selection, (Selection{{0, 0}, {0, 1}, {0, 4}})) << "Shift adds";
    EXPECT_TRUE(hand.idle());
    EXPECT_EQ(hand.steps(), 0);
}

TEST(SelectGesture, aBoxLosesAgainWhatItLeaves) {
    Hand hand = handOnCardinal();
    hand.press({-3.9, 2.25});
    hand.move({0.6, -1.5});
    EXPECT_EQ(hand.session.view.selection.size(), 3U) << "shown while the hand moves";
    hand.move({-1.5, -1.5});
    hand.release({-1.5, -1.5});
    EXPECT_EQ(hand.session.view.selection, (Selection{{0, 0}, {0, 1}}));
}

TEST(SelectGesture, aBoxThatIsGivenUpLeavesTheSelectionAsItWas) {
    for (const char* way : {"focus", "Esc", "right click"}) {
        Hand hand = handOnCardinal();
        hand.click(hand.place(6));
        hand.press({-3.9, 2.25}, withShift);
        hand.move({-1.5, -1.5}, withShift);
        ASSERT_EQ(hand.session.view.selection.size(), 3U);
        if (way[0] == 'f') {
            hand.cancel();
        } else if (way[0] == 'E') {
            hand.key(Key::escape);
        } else {
            hand.pressOther(Button::right, {-1.5, -1.5});
        }
        EXPECT_TRUE(hand.idle()) << way;
        EXPECT_EQ(hand.session.view.selection, (Selection{{0, 6}})) << way;
    }
}

TEST(SelectGesture, ofStackedPointsTheSelectedOneIsTakenThenTheActiveCurves) {
    Curve below = curveOf("cardinal");
    Curve above = curveOf("linear");
    Hand hand(documentOf({below, above}));
    hand.session.view.activeCurve = 1;
    hand.click(hand.place(2));
    EXPECT_EQ(hand.session.view.selection, (Selection{{1, 2}})) << "of the active curve";
    hand.session.view.selection = {{0, 2}};
    hand.drag(hand.place(2), {0.75, 0.5});
    EXPECT_EQ(hand.curve(0).points.at(2), (Point{0.75, 0.5})) << "the selected one moves";
    EXPECT_EQ(hand.curve(1).points, above.points);
}

TEST(SelectGesture, aPointOfAnotherCurveMakesThatCurveActive) {
    Curve two = curveOf("linear");
    two.points = {{-3, 3}, {-2.5, 2.5}};
    Hand hand(documentOf({curveOf("b-spline"), two}));
    hand.session.view.cursor = {hand.session.studies[0].pieces().size() - 1, 0.5};
    hand.click({-3, 3});
    EXPECT_EQ(hand.session.view.activeCurve, 1U);
    EXPECT_LT(hand.session.view.cursor.segment, hand.session.active()->pieces().size())
        << "u lies on a piece that the curve has";
    hand.session.view.cursor = {0, 0.5};
    hand.drag({-4.2, 3.2}, {-2.8, 2.8});
    EXPECT_EQ(hand.session.view.activeCurve, 1U);
    hand.drag({2.7, -1.6}, {3.2, -1});
    EXPECT_EQ(hand.session.view.activeCurve, 0U) << "a box activates as well";
    EXPECT_LT(hand.session.view.cursor.segment, hand.session.active()->pieces().size());
}

TEST(SelectGesture, aBoxOverSeveralCurvesKeepsTheCursorOnACurve) {
    Curve two = curveOf("linear");
    two.points = {{-3, 3}, {-2.5, 2.5}};
    Hand hand(documentOf({two, curveOf("b-spline")}));
    hand.session.view.activeCurve = 1;
    hand.session.view.cursor = {hand.session.studies[1].pieces().size() - 1, 0.5};
    hand.drag({-4.3, 3.4}, {4.3, -2.9});
    EXPECT_EQ(hand.session.view.selection.size(), 9U);
    EXPECT_LT(hand.session.view.cursor.segment, hand.session.active()->pieces().size());
}

TEST(SelectGesture, aGhostShowsOnOtherCurvesToo) {
    Curve other = curveOf("linear");
    for (std::size_t i = 0; i < other.points.size(); ++i) {
        other.points.set(i, other.points.at(i) + Point{0.3, 9});
    }
    Hand hand(documentOf({curveOf("cardinal"), other}));
    const PlanePoint there = hand.placeAt({1, 0.5}, 1);
    hand.move(there);
    ASSERT_TRUE(hand.session.view.ghost);
    EXPECT_EQ(hand.session.view.ghost->curve, 1U);
    hand.click(there, withControl);
    EXPECT_EQ(hand.curve(1).points.size(), other.points.size() + 1);
    EXPECT_EQ(hand.session.view.activeCurve, 1U);
    EXPECT_EQ(hand.steps(), 1);
}

TEST(SelectGesture, escapeClearsTheSelectionAndNothingElse) {
    Hand hand = handOnCardinal();
    hand.click(hand.place(3));
    ASSERT_FALSE(hand.session.view.selection.empty());
    hand.key(Key::escape);
    EXPECT_TRUE(hand.session.view.selection.empty());
    EXPECT_EQ(hand.steps(), 0);
}

TEST(SelectGesture, theHintNamesWhatIsUnderThePointer) {
    Hand hand = handOnCardinal();
    hand.move(hand.place(3));
    EXPECT_EQ(hand.session.view.hovered, (PointId{0, 3}));
    hand.move(hand.placeAt({2, 0.5}));
    EXPECT_FALSE(hand.session.view.hovered);
    ASSERT_TRUE(hand.session.view.ghost) << "over the curve a ghost point shows";
    EXPECT_EQ(hand.session.view.ghost->spot.segment, 2U);
    EXPECT_NEAR(hand.session.view.ghost->spot.u, 0.5, 1e-6);
    hand.move(nowhere);
    EXPECT_FALSE(hand.session.view.ghost);
}

} // namespace
} // namespace splineloft::ui
