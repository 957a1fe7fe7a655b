// Dragging control points: one drag is one step, nothing adds up, and giving up restores exactly.
#include "hand.h"

#include "core/document/edits.h"
#include "core/spline/catalog.h"
#include "ui/canvas/grid.h"

#include <gtest/gtest.h>

#include <cmath>

namespace splineloft::ui {
namespace {

Hand handOn(std::string_view family) {
    return Hand(documentOf({curveOf(family)}));
}

TEST(DragGesture, movesThePointAndNothingElseInOneStep) {
    for (const auto& family : catalog()) {
        if (family.hasHandles) {
            continue;
        }
        Hand hand = handOn(family.id);
        const Curve before = hand.curve();
        hand.drag(hand.place(3), {1, 2});
        Curve wanted = before;
        wanted.points.set(3, {1, 2});
        EXPECT_EQ(hand.curve(), wanted) << family.id;
        EXPECT_EQ(hand.steps(), 1) << family.id;
        EXPECT_EQ(hand.session.history.undoLabel(), "Move P₃") << family.id;
        hand.key(Key::z, withControl);
        EXPECT_EQ(hand.curve(), before) << family.id;
        hand.key(Key::y, withControl);
        EXPECT_EQ(hand.curve(), wanted) << family.id;
    }
}

TEST(DragGesture, isTheWholeDisplacementHoweverManyMovesItTook) {
    Hand once = handOn("cardinal");
    Hand often = handOn("cardinal");
    const PlanePoint from = once.place(2);
    once.drag(from, {-0.33, 2.77});
    often.press(from);
    for (int i = 0; i <= 997; ++i) {
        const double part = i / 997.0;
        often.move({std::lerp(from.x, -0.33, part) + 0.2 * std::sin(40 * part),
                    std::lerp(from.y, 2.77, part)});
    }
    often.release({-0.33, 2.77});
    EXPECT_EQ(once.curve(), often.curve());
}

TEST(DragGesture, aTremblingClickMovesNothing) {
    Hand hand = handOn("cardinal");
    const Document before = hand.session.document();
    const PlanePoint at = hand.place(3);
    hand.press(at);
    hand.move({at.x + 0.02, at.y - 0.02}); // two pixels
    hand.release({at.x + 0.02, at.y - 0.02});
    EXPECT_EQ(hand.session.document(), before);
    EXPECT_EQ(hand.steps(), 0);
}

TEST(DragGesture, thereAndBackLeavesNoStep) {
    Curve crooked = curveOf("cardinal");
    crooked.points.set(3, {1.0 / 3, std::sqrt(2.0)});
    Hand hand(documentOf({crooked}));
    const PlanePoint at = hand.place(3);
    hand.press(at);
    hand.move({2, -2});
    hand.move(at);
    hand.release(at);
    EXPECT_EQ(hand.curve(), crooked) << "to the last bit";
    EXPECT_EQ(hand.steps(), 0);
}

TEST(DragGesture, givingUpRestoresToTheLastBit) {
    Curve crooked = curveOf("bezier-spline");
    crooked.points.set(3, {1.0 / 3, std::sqrt(2.0)});
    for (const char* way : {"focus", "Esc", "right click"}) {
        Hand hand(documentOf({crooked}));
        const PlanePoint at = hand.place(3);
        hand.press(at);
        hand.move({2, -2});
        ASSERT_NE(hand.curve(), crooked) << "the drag shows";
        if (way[0] == 'f') {
            hand.cancel();
        } else if (way[0] == 'E') {
            hand.key(Key::escape);
        } else {
            hand.pressOther(Button::right, {2, -2});
        }
        EXPECT_EQ(hand.curve(), crooked) << way;
        EXPECT_TRUE(hand.idle()) << way;
        hand.move({-2, 2});
        hand.release({-2, 2}); // the release that comes after all
        EXPECT_EQ(hand.curve(), crooked) << way;
        EXPECT_EQ(hand.steps(), 0) << way;
        EXPECT_EQ(hand.session.view.selection, (Selection{{0, 3}}))
            << way << ": the point stays selected";
    }
}

TEST(DragGesture, undoInMidDragTakesTheDragBackAndNoStepBefore) {
    Hand hand = handOn("cardinal");
    hand.drag(hand.place(1), {-1, 1});
    const Document before = hand.session.document();
    hand.press(hand.place(3));
    hand.move({2, -2});
    hand.key(Key::z, withControl);
    EXPECT_EQ(hand.session.document(), before);
    hand.move({0, 0});
    hand.release({0, 0});
    EXPECT_EQ(hand.session.document(), before) << "the drag is over";
    EXPECT_EQ(hand.steps(), 1);
}

TEST(DragGesture, shiftOnASelectedPointKeepsItsAxisToo) {
    Hand hand = handOn("cardinal");
    hand.click(hand.place(3));
    const Point start = hand.curve().points.at(3);
    hand.press(hand.place(3), withShift);
    hand.move({3.5, 1.5}, withShift);
    hand.release({3.5, 1.5}, withShift);
    EXPECT_EQ(hand.curve().points.at(3), (Point{3.5, start[1]}));
    EXPECT_EQ(hand.session.view.selection, (Selection{{0, 3}})) << "moved, it stays selected";
}

TEST(DragGesture, shiftKeepsTheLongerAxis) {
    Hand hand = handOn("cardinal");
    hand.press(hand.place(3));
    hand.move({3.5, 1.5}, withShift);
    hand.release({3.5, 1.5}, withShift);
    EXPECT_EQ(hand.curve().points.at(3), (Point{3.5, 1.125})) << "across";
    hand.press(hand.place(2));
    hand.move({0.5, 2}, withShift);
    hand.release({0.5, 2}, withShift);
    EXPECT_EQ(hand.curve().points.at(2), (Point{0.25, 2})) << "up";
}

TEST(DragGesture, shiftCountsWhileItIsHeld) {
    Hand hand = handOn("cardinal");
    hand.press(hand.place(3));
    hand.move({3.5, 1.5}, withShift);
    hand.move({3.5, 1.5});
    hand.release({3.5, 1.5});
    EXPECT_EQ(hand.curve().points.at(3), (Point{3.5, 1.5}));
}

TEST(DragGesture, controlSnapsToTheGridAndShowsWhere) {
    Hand hand = handOn("cardinal");
    const double step = fineGridStep(hand.session.view.camera, 1);
    hand.press(hand.place(3));
    hand.move({-0.55, -1.87}, withControl);
    const auto* drag = std::get_if<DraggingPoints>(&hand.session.gesture);
    ASSERT_TRUE(drag && drag->held.to) << "what it snaps to is seen before letting go";
    hand.release({-0.55, -1.87}, withControl);
    const Point at = hand.curve().points.at(3);
    for (int c = 0; c < 2; ++c) {
        EXPECT_NEAR(at[c] / step, std::round(at[c] / step), 1e-9) << "coordinate " << c;
    }
    EXPECT_LE(std::abs(at[0] + 0.55), step / 2 + 1e-12);
    EXPECT_LE(std::abs(at[1] + 1.87), step / 2 + 1e-12);
}

TEST(DragGesture, controlSnapsToPointsBeforeTheGrid) {
    Hand hand = handOn("cardinal");
    hand.press(hand.place(3));
    hand.move({-2.04, 1.45}, withControl);
    const auto* drag = std::get_if<DraggingPoints>(&hand.session.gesture);
    ASSERT_TRUE(drag && drag->held.to);
    EXPECT_EQ(*drag->held.to, hand.place(1)) << "the mark is on the point";
    hand.release({-2.04, 1.45}, withControl);
    EXPECT_EQ(hand.curve().points.at(3), hand.curve().points.at(1));
}

TEST(DragGesture, controlDoesNotSnapToPointsThatMoveAlong) {
    Hand hand = handOn("cardinal");
    hand.session.view.selection = {{0, 2}, {0, 3}};
    const double step = fineGridStep(hand.session.view.camera, 1);
    hand.press(hand.place(3));
    hand.move({0.27, -0.46}, withControl); // where P2 is
    hand.release({0.27, -0.46}, withControl);
    EXPECT_NEAR(hand.curve().points.at(3)[0], 0.27, step / 2 + 1e-12);
    EXPECT_EQ(hand.curve().points.at(2)[0] - hand.curve().points.at(3)[0], 0.25 - 1.5);
}

TEST(DragGesture, coordinatesStayAsShortAsAPixelIsWide) {
    Hand hand = handOn("cardinal");
    for (const double zoom : {1.0, 30.0, 1e4}) {
        hand.session.view.camera = {hand.place(3), 100 * zoom};
        const PlanePoint from = hand.place(3);
        const PlanePoint to{from.x + 0.7345678912 / zoom, from.y - 0.3219876543 / zoom};
        hand.drag(from, to);
        const double finest = std::pow(10, std::floor(-std::log10(100 * zoom)));
        for (int c = 0; c < 2; ++c) {
            const double value = hand.curve().points.at(3)[c];
            EXPECT_NEAR(value, c == 0 ? to.x : to.y, finest / 2 + 1e-12) << zoom;
            EXPECT_NEAR(value / finest, std::round(value / finest), 1e-6) << zoom << " " << value;
        }
    }
}

TEST(DragGesture, allThatIsSelectedMovesAlike) {
    Hand hand = handOn("b-spline");
    const Points before = hand.curve().points;
    hand.session.view.selection = {{0, 0}, {0, 3}, {0, 6}};
    hand.drag(hand.place(3), {2.25, 0.5});
    for (std::size_t i = 0; i < 7; ++i) {
        const Point moved = before.at(i) + Point{0.75, -0.625};
        EXPECT_LE(distance(hand.curve().points.at(i), i % 3 == 0 ? moved : before.at(i)), 1e-13);
    }
    EXPECT_EQ(hand.session.history.undoLabel(), "Move 3 points");
}

TEST(DragGesture, aTangentFollowsItsTipAtThriceTheWay) {
    Hand hand = handOn("hermite");
    const Point before = hand.curve().tangents.at(3);
    const Points points = hand.curve().points;
    const PlanePoint tip{1.5 + before[0] / 3, 1.125 + before[1] / 3};
    hand.drag(tip, {tip.x - 0.4, tip.y + 0.9});
    EXPECT_EQ(hand.curve().points, points);
    const Point now = hand.curve().tangents.at(3);
    EXPECT_LE(distance(now, before + Point{-1.2, 2.7}), 3 * 0.01 * std::sqrt(2.0));
    EXPECT_EQ(hand.session.history.undoLabel(), "Move the tangent at P₃");
    EXPECT_EQ(hand.steps(), 1);
}

TEST(DragGesture, alignedHandlesStayAligned) {
    Hand hand = handOn("bezier-spline");
    Document smooth = setPoint(hand.session.document(), {0, 2}, {0.5, 0.125});
    smooth = setPoint(smooth, {0, 4}, {3.5, 3.125}); // (1, 1) and (2, 2) from anchor (1.5, 1.125)
    hand.session.apply({smooth, Phase::commit, "smooth"});
    hand.press({0.5, 0.125});
    for (const PlanePoint& to : {PlanePoint{0, 2}, {-1, 1.125}, {0.5, 2.5}, {1.5, -1}}) {
        hand.move(to);
        const Point in = Point{1.5, 1.125} - hand.curve().points.at(2);
        const Point out = hand.curve().points.at(4) - Point{1.5, 1.125};
        EXPECT_NEAR(dot(in, out), norm(in) * norm(out), 1e-9) << to.x << "," << to.y;
        EXPECT_NEAR(norm(out), std::sqrt(8.0), 1e-9) << "the partner keeps its length";
    }
    hand.cancel();
    EXPECT_EQ(hand.session.document(), smooth);
}

TEST(DragGesture, anAnchorTakesItsHandlesAlong) {
    Hand hand = handOn("bezier-spline");
    const Points before = hand.curve().points;
    hand.drag(hand.place(3), {2.5, 1.62});
    for (std::size_t i = 2; i <= 4; ++i) {
        EXPECT_LE(distance(hand.curve().points.at(i), before.at(i) + Point{1, 0.495}), 1e-13) << i;
    }
}

TEST(DragGesture, whatCannotBeIsRefusedInWordsAndLeavesTheDocument) {
    Hand hand = handOn("cardinal");
    const Document before = hand.session.document();
    hand.session.view.camera = {{0, 0}, 1e-7};
    hand.session.view.selection = {{0, 3}};
    hand.press({0, 0});
    hand.move({3e9, 0});
    ASSERT_TRUE(hand.session.notice) << "already while dragging";
    EXPECT_TRUE(hand.session.notice->isProblem);
    EXPECT_EQ(hand.session.notice->text.find(" is not"),
              hand.session.notice->text.rfind(" is not"));
    EXPECT_NE(hand.session.notice->text.front(), ' ') << hand.session.notice->text;
    EXPECT_EQ(hand.session.document(), before);
    hand.release({3e9, 0});
    EXPECT_EQ(hand.session.document(), before);
    EXPECT_EQ(hand.steps(), 0);
}

TEST(DragGesture, keysThatEditWaitUntilTheHandIsDone) {
    struct Deed {
        const char* name;
        Key key;
        Modifiers held;
    };
    for (const auto& deed :
         {Deed{"delete points", Key::del, {}}, Deed{"delete", Key::del, withShift},
          Deed{"close", Key::c, {}}, Deed{"another family", Key::digit9, {}}}) {
        Hand hand = handOn("hermite");
        hand.key(Key::a, withControl);
        hand.press(hand.place(6));
        hand.move({0.1, 0.1});
        hand.key(deed.key, deed.held);
        hand.move({-1, 0.2});
        hand.release({-1, 0.2});
        EXPECT_TRUE(hand.idle()) << deed.name;
        EXPECT_FALSE(problemOf(hand.session.document())) << deed.name;
        EXPECT_EQ(hand.steps(), 1) << deed.name;
        EXPECT_EQ(hand.session.history.undoLabel(), "Move 7 points") << deed.name;
    }
}

} // namespace
} // namespace splineloft::ui
