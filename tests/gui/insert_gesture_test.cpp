// Inserting, deleting, sliding along the curve, nudging, and the view: zoom, pan.
#include "hand.h"

#include "core/spline/catalog.h"
#include "core/spline/measure/nearest.h"
#include "ui/canvas/grid.h"

#include <gtest/gtest.h>

#include <cmath>

namespace splineloft::ui {
namespace {

/// The greatest distance of points of one curve from another.
double deviation(const Pieces& from, const Pieces& to) {
    double most = 0;
    for (std::size_t i = 0; i < from.size(); ++i) {
        for (const double u : {0.0, 0.13, 0.37, 0.5, 0.71, 0.96}) {
            most = std::max(most, nearestTo(to, from.position({i, u}))->distance);
        }
    }
    return most;
}

TEST(InsertGesture, onABezierSplineTheShapeStays) {
    for (const bool closed : {false, true}) {
        for (std::size_t segment = 0; segment < 2; ++segment) {
            Hand hand(documentOf({curveOf("bezier-spline", closed)}));
            const Pieces before = hand.session.studies[0].pieces();
            hand.doubleClick(hand.placeAt({segment, 0.37}));
            const Pieces after = hand.session.studies[0].pieces();
            ASSERT_EQ(after.size(), before.size() + 1) << closed << segment;
            EXPECT_LE(deviation(before, after), 1e-12) << "closed " << closed;
            EXPECT_LE(deviation(after, before), 1e-12) << "closed " << closed;
            EXPECT_EQ(hand.steps(), 1);
        }
    }
}

TEST(InsertGesture, onBSplinesTheShapeStays) {
    for (const auto& [family, control] :
         {std::pair{"b-spline", false}, {"b-spline", true}, {"nurbs", false}, {"nurbs", true}}) {
        Hand hand(documentOf({curveOf(family)}));
        const Pieces before = hand.session.studies[0].pieces();
        const auto count = hand.curve().points.size();
        const PlanePoint at = hand.placeAt({before.size() / 2, 0.4});
        control ? hand.click(at, withControl) : hand.doubleClick(at);
        const Pieces after = hand.session.studies[0].pieces();
        ASSERT_EQ(after.size(), before.size() + 1) << family;
        EXPECT_LE(deviation(before, after), 1e-12) << family;
        EXPECT_LE(deviation(after, before), 1e-12) << family;
        EXPECT_GT(hand.curve().points.size(), count) << family;
        EXPECT_EQ(hand.session.view.selection.size(), 1U) << family;
        EXPECT_EQ(hand.steps(), 1) << family;
    }
}

TEST(InsertGesture, elsewhereThePointLandsOnTheCurveAndIsSelected) {
    for (const auto& family : catalog()) {
        if (family.usesKnots) {
            continue; // a new control point of theirs does not lie on the curve
        }
        for (const bool control : {false, true}) {
            Hand hand(documentOf({curveOf(family.id)}));
            const PlanePoint at = hand.placeAt({hand.session.studies[0].pieces().size() / 2, 0.4});
            const auto count = hand.curve().points.size();
            control ? hand.click(at, withControl) : hand.doubleClick(at);
            ASSERT_EQ(hand.curve().points.size(), count + (family.hasHandles ? 3 : 1)) << family.id;
            ASSERT_EQ(hand.session.view.selection.size(), 1U) << family.id;
            const PlanePoint added = hand.place(hand.session.view.selection.begin()->index);
            EXPECT_LE(std::hypot(added.x - at.x, added.y - at.y), 1e-9) << family.id;
            EXPECT_EQ(hand.steps(), 1) << family.id;
            EXPECT_TRUE(hand.session.history.undoLabel().starts_with("Insert P")) << family.id;
            EXPECT_FALSE(problemOf(hand.session.document())) << family.id;
        }
    }
}

TEST(InsertGesture, aDoubleClickOnAPointInsertsNothing) {
    Hand hand(documentOf({curveOf("cardinal")}));
    hand.doubleClick(hand.place(3));
    EXPECT_EQ(hand.curve().points.size(), 7U);
    EXPECT_EQ(hand.steps(), 0);
}

TEST(InsertGesture, aClickOnTheCurvePutsUThereAndADragSlidesIt) {
    Hand hand(documentOf({curveOf("cardinal")}));
    hand.session.view.playing = true;
    hand.press(hand.placeAt({1, 0.25}));
    EXPECT_EQ(hand.session.view.cursor.segment, 1U);
    EXPECT_NEAR(hand.session.view.cursor.u, 0.25, 1e-6);
    EXPECT_FALSE(hand.session.view.playing) << "the hand takes over";
    hand.move(hand.placeAt({4, 0.75}));
    EXPECT_EQ(hand.session.view.cursor.segment, 4U);
    EXPECT_NEAR(hand.session.view.cursor.u, 0.75, 1e-6);
    hand.move({100, 100}); // far off, u stays on the curve
    EXPECT_LE(hand.session.view.cursor.u, 1);
    hand.release({100, 100});
    EXPECT_TRUE(hand.idle());
    EXPECT_EQ(hand.steps(), 0) << "u is no part of the document";
}

TEST(InsertGesture, aCurveThatVanishesWhileSlidOnIsLetGo) {
    Hand hand(documentOf({curveOf("cardinal")}));
    hand.press(hand.placeAt({1, 0.25}));
    hand.key(Key::del, withShift);
    hand.move({1, 1});
    hand.release({1, 1});
    EXPECT_TRUE(hand.session.document().curves.empty());
    EXPECT_TRUE(hand.idle());
}

TEST(DeleteGesture, deletesWhatIsSelectedAndSelectsNothingElse) {
    for (const Key key : {Key::del, Key::backspace}) {
        Hand hand(documentOf({curveOf("cardinal")}));
        hand.session.view.selection = {{0, 1}, {0, 4}};
        hand.key(key);
        const Points seven = sevenPoints();
        Points wanted;
        for (const std::size_t i : {0, 2, 3, 5, 6}) {
            wanted.append(seven.at(i));
        }
        EXPECT_EQ(hand.curve().points, wanted);
        EXPECT_TRUE(hand.session.view.selection.empty()) << "the points that moved up were not";
        EXPECT_EQ(hand.steps(), 1);
        EXPECT_EQ(hand.session.history.undoLabel(), "Delete 2 points");
        hand.key(key);
        EXPECT_EQ(hand.steps(), 1) << "nothing is selected any more";
    }
}

TEST(DeleteGesture, withControlTheCurveHeals) {
    for (const Key key : {Key::del, Key::backspace}) {
        Hand hand(documentOf({curveOf("bezier-spline")}));
        const Pieces before = hand.session.studies[0].pieces();
        hand.doubleClick(hand.placeAt({1, 0.4}));
        ASSERT_EQ(hand.session.studies[0].pieces().size(), before.size() + 1);
        hand.key(key, withControl);
        const Pieces after = hand.session.studies[0].pieces();
        ASSERT_EQ(after.size(), before.size());
        EXPECT_LE(deviation(after, before), 1e-9) << "what was cut in heals without a trace";
        EXPECT_TRUE(hand.session.view.selection.empty());
        EXPECT_EQ(hand.steps(), 2);
        EXPECT_EQ(hand.session.history.undoLabel().substr(0, 15), "Delete and heal");
    }
}

TEST(DeleteGesture, theLastPointTakesTheCurveWithIt) {
    for (const auto& family : catalog()) {
        Hand hand(documentOf({curveOf(family.id), curveOf("linear")}));
        hand.key(Key::a, withControl);
        hand.key(Key::del);
        ASSERT_EQ(hand.session.document().curves.size(), 1U) << family.id;
        EXPECT_EQ(hand.curve().family, "linear") << family.id;
        EXPECT_TRUE(hand.session.view.selection.empty()) << family.id;
        hand.key(Key::z, withControl);
        EXPECT_EQ(hand.curve(), curveOf(family.id));
    }
}

TEST(DeleteGesture, whatUndoBringsBackIsSelected) {
    Hand hand(documentOf({curveOf("linear"), curveOf("cardinal")}));
    hand.session.view.activeCurve = 1;
    hand.session.view.selection = {{1, 1}, {1, 2}, {1, 6}};
    hand.key(Key::del);
    hand.session.view.activeCurve = 0;
    hand.session.view.selection = {{0, 3}, {1, 2}};
    hand.key(Key::z, withControl);
    EXPECT_EQ(hand.session.view.selection, (Selection{{1, 1}, {1, 2}, {1, 6}}));
    EXPECT_EQ(hand.session.view.activeCurve, 1U);
    hand.key(Key::y, withControl);
    EXPECT_TRUE(hand.session.view.selection.empty());
}

TEST(DeleteGesture, whereUndoTakesPointsAwayNoOtherIsSelectedInTheirStead) {
    Hand hand(documentOf({curveOf("cardinal")}));
    hand.doubleClick(hand.placeAt({1, 0.4}));
    ASSERT_EQ(hand.curve().points.size(), 8U);
    hand.session.view.selection = {{0, 5}};
    hand.key(Key::z, withControl);
    EXPECT_TRUE(hand.session.view.selection.empty()) << "number 5 is another point now";
    hand.key(Key::y, withControl);
    EXPECT_EQ(hand.session.view.selection, (Selection{{0, 2}})) << "the point that is there again";
}

TEST(DeleteGesture, ofABezierSplineUndoSelectsTheAnchorNotItsHandles) {
    for (const bool closed : {false, true}) {
        Hand hand(documentOf({curveOf("bezier-spline", closed)}));
        hand.session.view.selection = {{0, 3}};
        hand.key(Key::del);
        hand.key(Key::z, withControl);
        EXPECT_EQ(hand.session.view.selection, (Selection{{0, 3}}));
    }
}

TEST(DeleteGesture, aCurveThatComesBackIsTheActiveOne) {
    Hand hand(documentOf({curveOf("linear"), curveOf("cardinal"), curveOf("b-spline")}));
    hand.session.view.activeCurve = 1;
    hand.key(Key::del, withShift);
    ASSERT_EQ(hand.session.document().curves.size(), 2U);
    hand.key(Key::z, withControl);
    EXPECT_EQ(hand.session.view.activeCurve, 1U);
    EXPECT_EQ(hand.session.view.selection.size(), 7U);
    EXPECT_EQ(hand.session.view.selection.begin()->curve, 1U);
}

TEST(DeleteGesture, downToNothingOneByOneAndBack) {
    for (const auto& family : catalog()) {
        for (const bool closed : {false, true}) {
            if (closed && !family.closable) {
                continue;
            }
            Hand hand(documentOf({curveOf(family.id, closed)}));
            const Document before = hand.session.document();
            for (int i = 0; i < 9 && !hand.session.document().curves.empty(); ++i) {
                hand.session.view.selection = {{0, 0}};
                hand.key(Key::del);
                EXPECT_FALSE(problemOf(hand.session.document())) << family.id << " after " << i;
            }
            EXPECT_TRUE(hand.session.document().curves.empty()) << family.id;
            while (hand.session.history.canUndo()) {
                hand.key(Key::z, withControl);
            }
            EXPECT_EQ(hand.session.document(), before) << family.id;
        }
    }
}

TEST(NudgeGesture, aTenthOfTheGridAndWithShiftTheGrid) {
    Hand hand(documentOf({curveOf("cardinal")}));
    hand.session.view.selection = {{0, 3}};
    const double step = fineGridStep(hand.session.view.camera, 1);
    hand.key(Key::right);
    EXPECT_NEAR(hand.curve().points.at(3)[0], 1.5 + step / 10, 1e-12);
    hand.key(Key::up, withShift);
    EXPECT_NEAR(hand.curve().points.at(3)[1], 1.125 + step, 1e-12);
    hand.key(Key::left);
    hand.key(Key::down, withShift);
    EXPECT_LE(distance(hand.curve().points.at(3), Point{1.5, 1.125}), 1e-13) << "and back";
    EXPECT_EQ(hand.steps(), 4);
    hand.session.view.selection.clear();
    hand.key(Key::right);
    EXPECT_EQ(hand.steps(), 4) << "nothing selected, nothing nudged";
}

TEST(ViewGesture, middleDragPansAndKeepsThePlaneUnderThePointer) {
    for (const Tool tool : {Tool::select, Tool::pen}) {
        Hand hand(documentOf({curveOf("cardinal")}));
        hand.session.view.tool = tool;
        const ScreenPoint from{300, 300}, to{477, 191};
        const PlanePoint held = hand.viewport().toPlane(from);
        hand.pressOther(Button::middle, held);
        for (const double part : {0.2, 0.9, 1.0}) {
            hand.move(hand.viewport().toPlane(
                ScreenPoint{std::lerp(from.x, to.x, part), std::lerp(from.y, to.y, part)}));
        }
        const PlanePoint now = hand.viewport().toPlane(to);
        EXPECT_LE(std::hypot(now.x - held.x, now.y - held.y), 1e-12);
        hand.releaseOther(Button::middle, now);
        EXPECT_TRUE(hand.idle());
        EXPECT_EQ(hand.steps(), 0);
    }
}

TEST(ViewGesture, undoNeverMovesTheCameraNorSelectsWhatIsNotThere) {
    Hand hand(documentOf({curveOf("cardinal")}));
    hand.key(Key::p);
    for (int i = 0; i < 5; ++i) {
        hand.click({-3 + 0.4 * i, 2.75});
    }
    hand.key(Key::a, withControl);
    const Camera camera{{3, 7}, 55};
    hand.session.view.camera = camera;
    while (hand.session.history.canUndo()) {
        hand.key(Key::z, withControl);
        EXPECT_EQ(hand.session.view.camera, camera);
        for (const auto& id : hand.session.view.selection) {
            EXPECT_LT(id.index, hand.curve().points.size());
        }
    }
    while (hand.session.history.canRedo()) {
        hand.key(Key::z, {.shift = true, .control = true});
        EXPECT_EQ(hand.session.view.camera, camera);
    }
    EXPECT_EQ(hand.curve().points.size(), 12U);
}

} // namespace
} // namespace splineloft::ui
