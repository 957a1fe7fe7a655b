// The pen: adds at the end, pulls out handles, closes, ends.
#include "hand.h"

#include "core/document/edits.h"
#include "core/spline/catalog.h"
#include "ui/canvas/gesture.h"
#include "ui/canvas/illustrate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace splineloft::ui {
namespace {

Hand penOn(Document document) {
    Hand hand(std::move(document));
    hand.key(Key::p);
    return hand;
}

TEST(PenGesture, addsAtTheEndOfTheActiveCurve) {
    for (const auto& family : catalog()) {
        if (family.hasHandles) {
            continue;
        }
        Hand hand = penOn(documentOf({curveOf(family.id)}));
        hand.click({-1.25, 2.75});
        ASSERT_EQ(hand.curve().points.size(), 8U) << family.id;
        EXPECT_EQ(hand.curve().points.at(7), (Point{-1.25, 2.75})) << family.id;
        EXPECT_EQ(hand.steps(), 1) << family.id;
        EXPECT_EQ(hand.session.view.selection, (Selection{{0, 7}})) << family.id;
        EXPECT_EQ(hand.session.history.undoLabel(), "Add P₇") << family.id;
        EXPECT_FALSE(problemOf(hand.session.document())) << family.id;
    }
}

TEST(PenGesture, anEmptyDocumentTakesTheFamilyOfItsFirstCurve) {
    int digit = 0;
    for (const auto& family : catalog().first(9)) {
        Hand hand = penOn({});
        hand.key(static_cast<Key>(static_cast<int>(Key::digit0) + ++digit));
        EXPECT_EQ(hand.steps(), 0);
        hand.click({0, 0});
        ASSERT_EQ(hand.session.document().curves.size(), 1U) << family.id;
        EXPECT_EQ(hand.curve().family, family.id);
        EXPECT_FALSE(problemOf(hand.session.document())) << family.id;
    }
}

TEST(PenGesture, theHandleBeingPulledIsUnderThePointer) {
    Hand hand = penOn(documentOf({curveOf("bezier-spline")}));
    const auto handles = [&](PlanePoint at) {
        const Situation situation{hand.session.history.settled(), hand.session.history.live(),
                                  hand.session.studies, hand.viewport(), 1};
        const Scene scene = illustrate(hand.session.view, hand.session.gesture, situation);
        const ScreenPoint there = hand.viewport().toScreen(at);
        return std::ranges::count_if(scene.marks, [&](const SceneMark& mark) {
            return mark.ink.role == Role::handle &&
                   std::hypot(mark.at.x - there.x, mark.at.y - there.y) < 0.5;
        });
    };
    hand.press({-1.25, 2.75});
    EXPECT_EQ(handles({-0.75, 3.25}), 0);
    hand.move({-0.75, 3.25});
    EXPECT_EQ(handles({-0.75, 3.25}), 1);
    EXPECT_EQ(handles({-1.75, 2.25}), 1) << "and the one opposite";
    hand.release({-0.75, 3.25});
    EXPECT_EQ(hand.curve().points.size(), 10U) << "no point of the curve yet";
}

TEST(PenGesture, beginsACurveWhereThereIsNone) {
    Hand hand = penOn({});
    hand.click({-1, 1});
    hand.click({1, 1.5});
    hand.click({2, -1});
    ASSERT_EQ(hand.session.document().curves.size(), 1U);
    EXPECT_EQ(hand.curve().points, (Points{{-1, 1}, {1, 1.5}, {2, -1}}));
    EXPECT_EQ(hand.steps(), 3) << "a step a point";
    for (int i = 0; i < 3; ++i) {
        hand.key(Key::z, withControl);
    }
    EXPECT_TRUE(hand.session.document().curves.empty());
}

TEST(PenGesture, beginsANewCurveOfTheSameFamilyBesideAClosedOne) {
    for (const auto& family : catalog()) {
        if (!family.closable) {
            continue;
        }
        Hand hand = penOn(documentOf({curveOf(family.id, true)}));
        hand.click({-1, 2.75});
        ASSERT_EQ(hand.session.document().curves.size(), 2U) << family.id;
        EXPECT_EQ(hand.curve(1).family, family.id);
        EXPECT_EQ(hand.session.view.activeCurve, 1U) << family.id;
        EXPECT_FALSE(problemOf(hand.session.document())) << family.id;
    }
}

TEST(PenGesture, pullsOutTheHandleOfABezierSpline) {
    Hand hand = penOn(documentOf({curveOf("bezier-spline")}));
    hand.drag({-1, 2}, {-0.5, 2.75});
    ASSERT_EQ(hand.curve().points.size(), 10U);
    EXPECT_EQ(hand.curve().points.at(9), (Point{-1, 2}));
    EXPECT_LE(distance(hand.curve().points.at(8), Point{-1.5, 1.25}), 1e-12)
        << "the handle arriving is opposite to the hand";
    EXPECT_EQ(hand.steps(), 1);
    hand.click({-3, 2});
    EXPECT_LE(distance(hand.curve().points.at(10), Point{-0.5, 2.75}), 1e-12)
        << "and the handle leaving is where the hand let go";
}

TEST(PenGesture, pullsOutTheHandleOfTheFirstPoint) {
    Hand hand = penOn(documentOf({curveOf("bezier-spline", true)}));
    hand.drag({-1, 2}, {-0.5, 2.75});
    ASSERT_EQ(hand.session.document().curves.size(), 2U);
    EXPECT_EQ(hand.curve(1).points, (Points{{-1, 2}, {-0.5, 2.75}}));
    EXPECT_FALSE(problemOf(hand.session.document()));
    hand.drag({1, 2}, {1, 1});
    ASSERT_EQ(hand.curve(1).points.size(), 4U);
    EXPECT_EQ(hand.curve(1).points.at(1), (Point{-0.5, 2.75})) << "it stays";
    EXPECT_EQ(hand.curve(1).points.at(2), (Point{1, 3})) << "opposite to the hand";
    EXPECT_EQ(hand.curve(1).points.at(3), (Point{1, 2}));
    EXPECT_EQ(hand.steps(), 2);
    hand.session.undo();
    hand.session.undo();
    EXPECT_EQ(hand.session.document().curves.size(), 1U);
}

TEST(PenGesture, pullsOutTheTangentOfAHermiteSpline) {
    Hand hand = penOn(documentOf({curveOf("hermite")}));
    hand.drag({-1, 2}, {-0.5, 2.75});
    ASSERT_EQ(hand.curve().tangents.size(), 8U);
    EXPECT_LE(distance(hand.curve().tangents.at(7), Point{1.5, 2.25}), 1e-12);
}

TEST(PenGesture, keepsToEightDirectionsFromTheLastPointWithShift) {
    Hand hand = penOn({});
    hand.click({-1, 1}, withShift);
    EXPECT_EQ(hand.curve().points, (Points{{-1, 1}})) << "there is nothing to go on from yet";
    hand.press({1.5, 1.25}, withShift);
    const auto* placing = std::get_if<PlacingPoint>(&hand.session.gesture);
    ASSERT_NE(placing, nullptr);
    EXPECT_EQ(placing->held.course, Course::across) << "the line that it keeps to is seen";
    hand.release({1.5, 1.25}, withShift);
    EXPECT_EQ(hand.curve().points.at(1), (Point{1.5, 1}));
    hand.click({2.5, 1.75}, withShift);
    const Point last = hand.curve().points.at(2);
    EXPECT_NEAR(last[0] - 1.5, last[1] - 1, 1e-12) << "at 45 degrees";
    EXPECT_GT(last[0], 2);
}

TEST(PenGesture, keepsHandlesToEightDirectionsWithShift) {
    Hand hand = penOn(documentOf({curveOf("bezier-spline")}));
    hand.press({-1, 2});
    hand.move({-0.5, 2.05}, withShift);
    hand.release({-0.5, 2.05}, withShift);
    const auto last = hand.curve().points.size() - 1;
    EXPECT_EQ(hand.curve().points.at(last - 1)[1], hand.curve().points.at(last)[1]);
    EXPECT_LT(hand.curve().points.at(last - 1)[0], hand.curve().points.at(last)[0]);
}

TEST(PenGesture, snapsToPointsAndGridWithControl) {
    Hand hand = penOn(documentOf({curveOf("cardinal"), curveOf("linear")}));
    const PlanePoint other = hand.place(3, 1);
    hand.press({other.x + 0.03, other.y - 0.03}, withControl);
    const auto* placing = std::get_if<PlacingPoint>(&hand.session.gesture);
    ASSERT_TRUE(placing && placing->held.to) << "what it snaps to is seen before letting go";
    EXPECT_EQ(*placing->held.to, other);
    hand.release({other.x + 0.03, other.y - 0.03}, withControl);
    EXPECT_EQ(hand.curve().points.at(7), (Point{other.x, other.y}));
}

TEST(PenGesture, givingUpTakesThePointAwayAgain) {
    for (const auto& family : {"cardinal", "bezier-spline", "hermite"}) {
        for (const bool byKey : {false, true}) {
            Hand hand = penOn(documentOf({curveOf(family)}));
            const Document before = hand.session.document();
            hand.press({-1, 2});
            hand.move({-0.5, 2.75});
            ASSERT_FALSE(hand.session.document() == before);
            byKey ? hand.key(Key::escape) : hand.pressOther(Button::right, {-0.5, 2.75});
            EXPECT_EQ(hand.session.document(), before) << family;
            EXPECT_EQ(hand.session.view.tool, Tool::pen) << "only the point was given up";
            hand.release({-0.5, 2.75});
            EXPECT_EQ(hand.steps(), 0) << family;
        }
    }
}

TEST(PenGesture, closesOnTheFirstPoint) {
    for (const auto& family : {"cardinal", "b-spline", "bezier-spline", "hermite", "natural"}) {
        Hand hand = penOn(documentOf({curveOf(family)}));
        hand.click(hand.place(0));
        EXPECT_TRUE(hand.curve().closed) << family;
        EXPECT_EQ(hand.session.view.tool, Tool::select) << family << ": the pen has done its work";
        EXPECT_EQ(hand.steps(), 1);
        EXPECT_FALSE(problemOf(hand.session.document())) << family;
    }
}

TEST(PenGesture, doesNotCloseWhereTheFirstPointIsNoLongerUnderThePointer) {
    Hand hand = penOn(documentOf({curveOf("cardinal")}));
    const ScreenPoint at = hand.viewport().toScreen(hand.place(0));
    hand.move(hand.place(0));
    hand.session.view.camera = panned(hand.session.view.camera, 200, 100); // as F or the wheel do
    hand.press(hand.viewport().toPlane(at));
    hand.release(hand.viewport().toPlane(at));
    EXPECT_FALSE(hand.curve().closed);
    EXPECT_EQ(hand.curve().points.size(), 8U);
}

TEST(PenGesture, endsWithEnterAndEscape) {
    for (const Key key : {Key::escape, Key::enter, Key::keypadEnter, Key::v}) {
        Hand hand = penOn(documentOf({curveOf("cardinal")}));
        hand.click({-1, 2.75});
        hand.key(key);
        EXPECT_EQ(hand.session.view.tool, Tool::select) << static_cast<int>(key);
        EXPECT_EQ(hand.curve().points.size(), 8U) << "what was added stays";
    }
}

TEST(PenGesture, undoInMidPlacementLeavesNoPoint) {
    Hand hand = penOn(documentOf({curveOf("cardinal")}));
    const Document before = hand.session.document();
    hand.press({-1, 2});
    hand.key(Key::z, withControl);
    hand.move({0, 0});
    hand.release({0, 0});
    EXPECT_EQ(hand.session.document(), before);
}

TEST(PenGesture, keysThatEditWaitUntilThePointIsDown) {
    for (const Key key : {Key::up, Key::del, Key::c, Key::backspace}) {
        Hand hand = penOn(documentOf({curveOf("cardinal")}));
        hand.press({-1, 2});
        hand.key(key);
        hand.release({-1, 2});
        EXPECT_EQ(hand.curve().points.size(), 8U) << static_cast<int>(key);
        EXPECT_EQ(hand.steps(), 1) << static_cast<int>(key);
    }
}

TEST(PenGesture, refusesAPointTooManyInWords) {
    Curve full = curveOf("bezier");
    const auto most = familyOf(full).mostPoints;
    for (std::size_t i = full.points.size(); i < most; ++i) {
        full.points.append(Point{0.01 * static_cast<double>(i), 1});
    }
    Hand hand = penOn(documentOf({full}));
    hand.click({-1, 2.75});
    EXPECT_EQ(hand.curve().points.size(), most);
    ASSERT_TRUE(hand.session.notice);
    EXPECT_TRUE(hand.session.notice->isProblem);
    EXPECT_EQ(hand.steps(), 0);
}

} // namespace
} // namespace splineloft::ui
