// The frame around several selected points: grips scale, the ring turns, exactly and in one step.
#include "hand.h"

#include <gtest/gtest.h>

#include "ui/canvas/illustrate.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace splineloft::ui {
namespace {

/// A hand with points 1, 2, 3 of the seven selected.
Hand handOnThree(std::string_view family = "cardinal") {
    Hand hand(documentOf({curveOf(family)}));
    hand.session.view.selection = {{0, 1}, {0, 2}, {0, 3}};
    return hand;
}

Gizmo gizmoOf(const Hand& hand) {
    return *ui::gizmoOf(hand.session.document(), hand.session.view, hand.viewport(), 1);
}

PlanePoint gripOf(const Hand& hand, Grip grip) {
    return hand.viewport().toPlane(gizmoOf(hand).placeOf(grip));
}

/// Drags a grip by so much of the plane.
void pull(Hand& hand, Grip grip, double dx, double dy, Modifiers held = {}) {
    const PlanePoint from = gripOf(hand, grip);
    hand.drag(from, {from.x + dx, from.y + dy}, held);
}

TEST(TransformGesture, needsTwoPointsThatLieApart) {
    Hand hand(documentOf({curveOf("cardinal")}));
    const auto shown = [&] {
        return ui::gizmoOf(hand.session.document(), hand.session.view, hand.viewport(), 1);
    };
    EXPECT_FALSE(shown());
    hand.session.view.selection = {{0, 1}};
    EXPECT_FALSE(shown());
    hand.session.view.selection = {{0, 1}, {0, 2}};
    EXPECT_TRUE(shown());
    hand.session.view.tool = Tool::pen;
    EXPECT_FALSE(shown()) << "the pen has no use for it";
}

TEST(TransformGesture, theRingIsInViewWhereverTheFrameReaches) {
    Hand hand = handOnThree();
    const auto ringFor = [&](Camera camera) {
        hand.session.view.camera = camera;
        const Gizmo gizmo = gizmoOf(hand);
        EXPECT_TRUE(hand.session.canvas.contains(gizmo.ring)) << camera.pixelsPerUnit;
        return std::pair{gizmo.ring, gizmo.frame};
    };
    const Camera usual = hand.session.view.camera;
    const auto [above, frame] = ringFor(usual);
    EXPECT_LT(above.y, frame.top);
    Camera lower = usual;
    lower.centre.y -= (frame.top - hand.session.canvas.top) / usual.pixelsPerUnit;
    const auto [below, higher] = ringFor(lower);
    EXPECT_GT(below.y, higher.bottom());
    Camera near = usual;
    near.pixelsPerUnit *= 50;
    ringFor(near);
    pull(hand, {0, 0}, 0.01, 0.02);
    EXPECT_EQ(hand.steps(), 1) << "and it turns from there";
}

TEST(TransformGesture, whileItTurnsTheFrameTurnsAlong) {
    Hand hand = handOnThree();
    const ScreenRect frame = gizmoOf(hand).frame;
    const PlanePoint from = gripOf(hand, {0, 0});
    const PlanePoint middle = gizmoOf(hand).box.middle();
    hand.move(from);
    hand.press(from);
    hand.move({middle.x + (from.y - middle.y), middle.y}); // a quarter, to the right
    const auto& view = hand.session.view;
    const Situation situation{hand.session.history.settled(), hand.session.history.live(),
                              hand.session.studies, hand.viewport(), 1};
    const Scene scene = illustrate(view, hand.session.gesture, situation);
    const auto drawn = std::ranges::find_if(scene.strokes, [](const SceneStroke& stroke) {
        return stroke.ink.role == Role::gizmo && stroke.points.size() == 4;
    });
    ASSERT_NE(drawn, scene.strokes.end());
    const auto side = [&](std::size_t i) {
        const auto& [a, b] = std::pair{drawn->points[i], drawn->points[i + 1]};
        return std::hypot(b.x - a.x, b.y - a.y);
    };
    EXPECT_NEAR(side(0), frame.width, 1e-6);
    EXPECT_NEAR(side(1), frame.height, 1e-6);
    EXPECT_NEAR(drawn->points[0].x, drawn->points[1].x, 1e-6) << "what was on top stands upright";
}

TEST(TransformGesture, aCornerScalesAboutTheOpposite) {
    Hand hand = handOnThree();
    const PlaneBox box = gizmoOf(hand).box;
    const Points before = hand.curve().points;
    pull(hand, {1, 1}, box.width(), 0.5 * box.height());
    for (const std::size_t i : {1U, 2U, 3U}) {
        const Point p = before.at(i);
        const Point wanted{box.low.x + 2 * (p[0] - box.low.x),
                           box.low.y + 1.5 * (p[1] - box.low.y)};
        EXPECT_LE(distance(hand.curve().points.at(i), wanted), 1e-9) << i;
    }
    EXPECT_EQ(hand.curve().points.at(0), before.at(0)) << "what is not selected stays";
    EXPECT_EQ(hand.steps(), 1);
    EXPECT_EQ(hand.session.history.undoLabel(), "Scale 3 points");
    hand.key(Key::z, withControl);
    EXPECT_EQ(hand.curve().points, before);
}

TEST(TransformGesture, aSideScalesOneAxis) {
    Hand hand = handOnThree();
    const PlaneBox box = gizmoOf(hand).box;
    const Points before = hand.curve().points;
    pull(hand, {-1, 0}, -box.width(), 3);
    for (const std::size_t i : {1U, 2U, 3U}) {
        EXPECT_NEAR(hand.curve().points.at(i)[0], box.high.x + 2 * (before.at(i)[0] - box.high.x),
                    1e-9);
        EXPECT_EQ(hand.curve().points.at(i)[1], before.at(i)[1]);
    }
}

TEST(TransformGesture, shiftKeepsTheProportions) {
    Hand hand = handOnThree();
    const PlaneBox box = gizmoOf(hand).box;
    pull(hand, {1, -1}, 0.7, -0.1, withShift);
    const PlaneBox after = gizmoOf(hand).box;
    EXPECT_NEAR(after.width() / box.width(), after.height() / box.height(), 1e-9);
    EXPECT_GT(after.width(), box.width());
}

TEST(TransformGesture, altScalesAboutTheMiddle) {
    Hand hand = handOnThree();
    const PlaneBox box = gizmoOf(hand).box;
    pull(hand, {1, 0}, 0.5 * box.width(), 0, {.alt = true});
    const PlaneBox after = gizmoOf(hand).box;
    EXPECT_NEAR(after.middle().x, box.middle().x, 1e-9);
    EXPECT_NEAR(after.width(), 2 * box.width(), 1e-9);
}

TEST(TransformGesture, theRingTurnsAboutTheMiddle) {
    Hand hand = handOnThree("natural");
    const PlaneBox box = gizmoOf(hand).box;
    const Points before = hand.curve().points;
    const PlanePoint ring = gripOf(hand, {});
    const double arm = ring.y - box.middle().y;
    hand.drag(ring, {box.middle().x - arm, box.middle().y});
    for (const std::size_t i : {1U, 2U, 3U}) {
        const double x = before.at(i)[0] - box.middle().x;
        const double y = before.at(i)[1] - box.middle().y;
        const Point wanted{box.middle().x - y, box.middle().y + x};
        EXPECT_LE(distance(hand.curve().points.at(i), wanted), 1e-9) << "a quarter to the left";
    }
    EXPECT_EQ(hand.session.history.undoLabel(), "Turn 3 points");
}

TEST(TransformGesture, turnsInStepsWhileAKeyIsHeld) {
    for (const auto& [held, step] : {std::pair{withShift, 45.0}, std::pair{withControl, 15.0}}) {
        Hand hand = handOnThree();
        const Point before = hand.curve().points.at(3) - hand.curve().points.at(1);
        const PlanePoint ring = gripOf(hand, {});
        hand.drag(ring, {ring.x + 1.9, ring.y - 0.2}, held);
        const Point now = hand.curve().points.at(3) - hand.curve().points.at(1);
        const double angle = std::remainder(
            std::atan2(now[1], now[0]) - std::atan2(before[1], before[0]), 2 * std::numbers::pi);
        const double steps = angle * 180 / std::numbers::pi / step;
        EXPECT_NEAR(steps, std::round(steps), 1e-9);
        EXPECT_NE(std::round(steps), 0);
    }
}

TEST(TransformGesture, tangentsAndHandlesGoAlong) {
    Hand hermite = handOnThree("hermite");
    const PlaneBox box = gizmoOf(hermite).box;
    const Point tangent = hermite.curve().tangents.at(2);
    pull(hermite, {1, 1}, box.width(), box.height());
    EXPECT_LE(distance(hermite.curve().tangents.at(2), 2 * tangent), 1e-9);

    Hand bezier(documentOf({curveOf("bezier-spline")}));
    bezier.session.view.selection = {{0, 0}, {0, 3}};
    const Points before = bezier.curve().points;
    const PlaneBox anchors = gizmoOf(bezier).box;
    pull(bezier, {1, 1}, anchors.width(), anchors.height());
    for (std::size_t i = 0; i <= 4; ++i) {
        const Point low{anchors.low.x, anchors.low.y};
        EXPECT_LE(distance(bezier.curve().points.at(i), low + 2 * (before.at(i) - low)), 1e-9) << i;
    }
}

/// The two ways to give up what the hand is doing.
void giveUp(Hand& hand, bool byKey, PlanePoint at) {
    if (byKey) {
        hand.key(Key::escape);
    } else {
        hand.pressOther(Button::right, at);
        hand.releaseOther(Button::right, at);
    }
}

TEST(TransformGesture, escapeAndTheRightButtonRestoreAndAClickDoesNothing) {
    Hand hand = handOnThree();
    const Document before = hand.session.document();
    for (const bool byKey : {true, false}) {
        for (const Grip& which : {Grip{1, 1}, Grip{-1, 0}, Grip{}}) {
            const PlanePoint grip = gripOf(hand, which);
            const PlanePoint far{grip.x + 1, grip.y + 1};
            hand.press(grip);
            hand.move(far);
            EXPECT_NE(hand.session.document(), before) << "it shows while it is pulled";
            giveUp(hand, byKey, far);
            EXPECT_EQ(hand.session.document(), before);
            hand.move(grip);
            hand.release(grip);
            EXPECT_EQ(hand.session.document(), before) << "the pull is over";
        }
    }
    hand.click(gripOf(hand, {1, 1}));
    EXPECT_EQ(hand.session.document(), before);
    EXPECT_EQ(hand.steps(), 0);
    EXPECT_EQ(hand.session.view.selection.size(), 3U) << "they stay selected";
}

TEST(TransformGesture, pointsOnALineHaveNoGripsAcrossIt) {
    Curve flat = curveOf("linear");
    flat.points.set(1, {0, 1});
    flat.points.set(2, {2, 1});
    Hand hand(documentOf({flat}));
    hand.session.view.selection = {{0, 1}, {0, 2}};
    for (const auto& grip : gizmoOf(hand).grips()) {
        EXPECT_EQ(grip.up, 0);
    }
    pull(hand, {1, 0}, 2, 0);
    EXPECT_LE(distance(hand.curve().points.at(2), Point{4, 1}), 1e-9);
}

TEST(StemGesture, slidesAWeightAtItsPoint) {
    Hand hand(documentOf({curveOf("nurbs")}));
    const auto stems = [&] {
        return stemsOf(hand.session.document(), hand.session.view, hand.viewport(), 1);
    };
    EXPECT_TRUE(stems().empty()) << "nothing is selected";
    hand.session.view.selection = {{0, 3}};
    ASSERT_EQ(stems().size(), 1U);
    const Stem stem = stems().front();
    EXPECT_EQ(stem.number, 1);
    const PlanePoint knob = hand.viewport().toPlane(stem.knob);
    const PlanePoint end = hand.viewport().toPlane(stem.to);
    hand.drag(knob, end);
    EXPECT_DOUBLE_EQ(hand.curve().weights.at(3), stem.value.parameter.sliderMost);
    EXPECT_EQ(hand.steps(), 1);
    EXPECT_EQ(hand.session.history.undoLabel(), "Set weight of P₃");
    hand.doubleClick(hand.viewport().toPlane(stems().front().knob));
    EXPECT_TRUE(hand.curve().weights.empty()) << "all are 1 again";
}

TEST(StemGesture, escapeAndTheRightButtonRestore) {
    Hand hand(documentOf({curveOf("nurbs")}));
    hand.session.view.selection = {{0, 3}};
    const Document before = hand.session.document();
    for (const bool byKey : {true, false}) {
        const auto stems = stemsOf(hand.session.document(), hand.session.view, hand.viewport(), 1);
        ASSERT_EQ(stems.size(), 1U);
        const PlanePoint end = hand.viewport().toPlane(stems.front().to);
        hand.press(hand.viewport().toPlane(stems.front().knob));
        hand.move(end);
        EXPECT_NE(hand.session.document(), before);
        giveUp(hand, byKey, end);
        EXPECT_EQ(hand.session.document(), before);
        hand.release(end);
        EXPECT_EQ(hand.session.document(), before) << "the slide is over";
    }
    EXPECT_EQ(hand.steps(), 0);
}

TEST(StemGesture, thereIsOneForEachLocalParameter) {
    Curve curve = curveOf("kochanek-bartels");
    curve.local = {{"tension", std::vector<double>(7, 0.25)}, {"bias", std::vector<double>(7, 0)}};
    Hand hand(documentOf({curve}));
    hand.session.view.selection = {{0, 2}};
    const auto stems = stemsOf(hand.session.document(), hand.session.view, hand.viewport(), 1);
    ASSERT_EQ(stems.size(), 2U);
    hand.drag(hand.viewport().toPlane(stems[0].knob), hand.viewport().toPlane(stems[0].from));
    const auto& local = hand.curve().local.at("tension");
    EXPECT_EQ(local.at(2), stems[0].value.parameter.sliderLeast);
    EXPECT_EQ(local.at(1), 0.25) << "its neighbours keep theirs";
}

} // namespace
} // namespace splineloft::ui
