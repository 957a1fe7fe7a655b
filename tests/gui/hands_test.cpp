// What hands expect beyond dragging: Space held to move the view, Tab through the points, points on
// top of one another, numbers typed in beside a point, the clipboard.
#include "driver.h"
#include "hand.h"

#include "core/document/handle_modes.h"
#include "ui/canvas/illustrate.h"
#include "ui/canvas/viewport.h"

#include <gtest/gtest.h>
#include <imgui.h>

#include <algorithm>
#include <set>

namespace splineloft::ui {
namespace {

TEST(Hands, spaceHeldMovesTheViewAndDoesNotPlay) {
    Driver driver(documentOf({curveOf("cardinal")}));
    driver.settle();
    const Camera before = driver.session.view.camera;
    const ScreenPoint from = driver.atPoint(3);
    driver.move(from);
    driver.send(KeyChanged{Key::space, true, false, {}});
    driver.settle();
    EXPECT_EQ(driver.result.pointer, PointerShape::move);
    driver.drag(from, {from.x + 90, from.y - 40});
    driver.send(KeyChanged{Key::space, false, false, {}});
    driver.settle();
    EXPECT_NEAR(driver.session.view.camera.centre.x, before.centre.x - 90 / before.pixelsPerUnit,
                1e-9);
    EXPECT_NEAR(driver.session.view.camera.centre.y, before.centre.y - 40 / before.pixelsPerUnit,
                1e-9);
    EXPECT_EQ(driver.steps(), 0) << "the point under it stays";
    EXPECT_FALSE(driver.session.view.playing);
}

TEST(Hands, spaceTappedPlays) {
    Driver driver(documentOf({curveOf("cardinal")}));
    driver.settle();
    driver.move(driver.at({0, 0}));
    driver.key(Key::space);
    EXPECT_TRUE(driver.session.view.playing);
    driver.key(Key::space);
    EXPECT_FALSE(driver.session.view.playing);
}

TEST(Hands, arrowsStepTheTravellerWhereNothingIsSelected) {
    Hand hand(documentOf({curveOf("cardinal")}));
    const Spot before = hand.session.view.cursor;
    const auto& lengths = hand.session.active()->lengths();
    const double start = lengths.upTo(before);
    hand.key(Key::right);
    EXPECT_NEAR(lengths.upTo(hand.session.view.cursor) - start, 0.01 * lengths.total(), 1e-9);
    hand.key(Key::left);
    EXPECT_NEAR(lengths.upTo(hand.session.view.cursor), start, 1e-9);
    hand.session.view.playing = true;
    hand.key(Key::left);
    EXPECT_FALSE(hand.session.view.playing) << "a step stops it";
    EXPECT_EQ(hand.steps(), 0);
}

TEST(Hands, arrowsThatStopThePlayMoveNoPoint) {
    Driver driver(documentOf({curveOf("cardinal")}));
    driver.settle();
    const Points before = driver.session.document().curves[0]->points;
    for (const bool held : {true, false}) {
        driver.session.view.selection = {{0, 3}};
        driver.session.view.playing = true;
        for (int k = 0; k < 3; ++k) {
            const Spot at = driver.session.view.cursor;
            if (held) {
                driver.send(KeyChanged{Key::left, true, k > 0, {}});
                driver.settle();
            } else {
                driver.key(Key::left);
            }
            EXPECT_FALSE(driver.session.view.cursor == at) << "it steps";
        }
        driver.send(KeyChanged{Key::left, false, false, {}});
        EXPECT_EQ(driver.session.document().curves[0]->points, before);
        EXPECT_EQ(driver.steps(), 0);
    }
}

TEST(Hands, tabGoesThroughThePointsAfterAClickInAPanel) {
    Driver driver(documentOf({curveOf("cardinal")}));
    driver.settle();
    driver.click(pointRow(2));
    ASSERT_EQ(driver.session.view.selection, (Selection{{0, 2}}));
    driver.move(driver.at({0, 0}));
    for (const std::size_t next : {3, 4, 5}) {
        driver.key(Key::tab);
        EXPECT_EQ(driver.session.view.selection, (Selection{{0, next}}));
        EXPECT_FALSE(ImGui::GetIO().WantTextInput) << "no field takes the keyboard";
    }
}

TEST(Hands, tabGoesThroughThePoints) {
    Hand hand(documentOf({curveOf("cardinal")}));
    const auto selected = [&] { return hand.session.view.selection; };
    hand.key(Key::tab);
    EXPECT_EQ(selected(), (Selection{{0, 0}}));
    hand.key(Key::tab);
    EXPECT_EQ(selected(), (Selection{{0, 1}}));
    hand.key(Key::tab, withShift);
    hand.key(Key::tab, withShift);
    EXPECT_EQ(selected(), (Selection{{0, 6}})) << "around the end";
    hand.key(Key::tab);
    EXPECT_EQ(selected(), (Selection{{0, 0}}));
}

TEST(Hands, shiftKeeps45Degrees) {
    Hand hand(documentOf({curveOf("cardinal")}));
    const Point before = hand.curve().points.at(3);
    hand.press(hand.place(3));
    hand.move({before[0] + 1.1, before[1] + 0.9}, withShift);
    const auto* drag = std::get_if<DraggingPoints>(&hand.session.gesture);
    ASSERT_TRUE(drag);
    EXPECT_EQ(drag->held.course, Course::rising) << "the line that it keeps to is seen";
    hand.release({before[0] + 1.1, before[1] + 0.9}, withShift);
    const Point way = hand.curve().points.at(3) - before;
    EXPECT_NEAR(way[0], way[1], 1e-12);
    EXPECT_NEAR(way[0], 1, 0.006);
    hand.drag(hand.place(3), {hand.place(3).x - 0.8, hand.place(3).y + 1}, withShift);
    const Point back = hand.curve().points.at(3) - before - way;
    EXPECT_NEAR(back[0], -back[1], 1e-12);
}

TEST(Hands, altClickTakesThePointBelow) {
    Curve stacked = curveOf("linear");
    stacked.points.set(4, stacked.points.at(2));
    stacked.points.set(5, stacked.points.at(2));
    Hand hand(documentOf({stacked}));
    const PlanePoint at = hand.place(2);
    Selection seen;
    hand.click(at);
    seen.insert(*hand.session.view.selection.begin());
    for (int i = 0; i < 2; ++i) {
        hand.click(at, {.alt = true});
        ASSERT_EQ(hand.session.view.selection.size(), 1U);
        seen.insert(*hand.session.view.selection.begin());
    }
    EXPECT_EQ(seen, (Selection{{0, 2}, {0, 4}, {0, 5}}));
    const std::size_t held = hand.session.view.selection.begin()->index;
    hand.drag(at, {at.x + 1, at.y});
    EXPECT_NE(hand.place(held), at) << "the selected one is dragged";
    EXPECT_EQ(hand.steps(), 1);
}

TEST(Hands, doubleClickOnAPointTypesItsNumbers) {
    Driver driver(documentOf({curveOf("cardinal")}));
    driver.settle();
    driver.doubleClick(driver.atPoint(2));
    driver.settle();
    ASSERT_EQ(driver.session.view.exactEntry, (PointId{0, 2}));
    driver.type("3+0.1");
    driver.key(Key::tab);
    driver.type("-2*0.5");
    driver.key(Key::enter);
    EXPECT_EQ(driver.curve().points.at(2), (Point{3.1, -1}));
    EXPECT_FALSE(driver.session.view.exactEntry) << "Enter ends it";
    driver.doubleClick(driver.atPoint(2));
    driver.type("77");
    driver.key(Key::escape);
    driver.settle();
    EXPECT_EQ(driver.curve().points.at(2), (Point{3.1, -1}));
    EXPECT_FALSE(driver.session.view.exactEntry);
}

TEST(Hands, theNumbersOfAPointAreAllThatItHas) {
    Driver driver(documentOf({curveOf("nurbs", 3)}));
    driver.settle();
    driver.doubleClick(driver.atPoint(2));
    driver.settle();
    ASSERT_EQ(driver.session.view.exactEntry, (PointId{0, 2}));
    for (const char* number : {"1/8", "2*4", "-5+0.25"}) {
        driver.type(number);
        driver.key(Key::tab);
    }
    driver.type("3*2");
    driver.key(Key::enter);
    EXPECT_EQ(driver.curve().points.at(2), (Point{0.125, 8, -4.75}));
    ASSERT_EQ(driver.curve().weights.size(), driver.curve().points.size());
    EXPECT_EQ(driver.curve().weights[2], 6);
    EXPECT_EQ(driver.steps(), 4) << "each number is a step";
}

TEST(Hands, wherePointsCanBeInsertedAGhostIsDrawn) {
    const auto ghosts = [](const Driver& driver) {
        const Situation situation{driver.session.history.settled(),
                                  driver.session.history.live(),
                                  driver.session.studies,
                                  {driver.session.view.camera, driver.session.canvas},
                                  1};
        const Scene scene = illustrate(driver.session.view, driver.session.gesture, situation);
        return std::ranges::count_if(
            scene.marks, [](const SceneMark& mark) { return mark.ink.role == Role::ghost; });
    };
    Driver driver(documentOf({curveOf("cardinal")}));
    driver.settle();
    const Point on = driver.session.active()->pieces().position({2, 0.4});
    driver.move(driver.at({on[0], on[1]}));
    EXPECT_EQ(ghosts(driver), 1);
    driver.move(driver.atPoint(3));
    EXPECT_EQ(ghosts(driver), 0) << "on a point a double click inserts nothing";
    driver.move(driver.at({-0.5, -1.75}));
    EXPECT_EQ(ghosts(driver), 0);
}

TEST(Clipboard, copiesCutsAndPastesPoints) {
    Driver driver(documentOf({curveOf("cardinal")}));
    driver.settle();
    driver.move(driver.at({0, 0}));
    driver.session.view.selection = {{0, 1}, {0, 2}, {0, 4}};
    driver.key(Key::c, withControl);
    EXPECT_NE(std::string(ImGui::GetClipboardText()).find("\"format\": \"splineloft\""),
              std::string::npos);
    driver.key(Key::v, withControl);
    ASSERT_EQ(driver.session.document().curves.size(), 2U);
    EXPECT_EQ(driver.curve().points.size(), 3U) << "the pasted curve is the active one";
    EXPECT_EQ(driver.session.view.selection.size(), 3U);
    driver.key(Key::x, withControl);
    EXPECT_EQ(driver.session.document().curves.size(), 1U);
    EXPECT_EQ(driver.steps(), 2);
}

TEST(Clipboard, copiesCutsAndPastesWholeCurvesWhereNoPointIsSelected) {
    Driver driver(documentOf({curveOf("b-spline")}));
    driver.settle();
    driver.move(driver.at({0, 0}));
    driver.key(Key::c, withControl);
    driver.key(Key::v, withControl);
    ASSERT_EQ(driver.session.document().curves.size(), 2U);
    EXPECT_EQ(driver.curve().family, "b-spline");
    const Points pasted = driver.curve().points;
    ASSERT_EQ(pasted.size(), 7U);
    for (std::size_t i = 0; i < 7; ++i) {
        EXPECT_LE(distance(pasted.at(i) - sevenPoints().at(i), pasted.at(0) - sevenPoints().at(0)),
                  1e-12)
            << "all are moved by the same";
    }
    driver.session.view.selection.clear();
    driver.key(Key::x, withControl);
    EXPECT_EQ(driver.session.document().curves.size(), 1U);
    driver.key(Key::v, withControl);
    EXPECT_EQ(driver.session.document().curves.size(), 2U);
    EXPECT_EQ(driver.steps(), 3);
}

TEST(Clipboard, whatIsPastedOutOfViewIsBroughtIntoView) {
    Driver driver(plain());
    const Camera before = driver.session.view.camera;
    ImGui::SetClipboardText("M 0 0 L 1 1");
    driver.key(Key::v, withControl);
    driver.frames(2);
    EXPECT_EQ(driver.session.view.camera, before);
    ImGui::SetClipboardText("M 300 200 L 500 400");
    driver.key(Key::v, withControl);
    driver.frames(2);
    ASSERT_EQ(driver.session.document().curves.size(), 3U);
    for (const PointId& id : driver.session.view.selection) {
        const Point p = driver.session.document().curves[id.curve]->points.at(id.index);
        EXPECT_TRUE(driver.session.canvas.contains(driver.at({p[0], p[1]})));
    }
}

TEST(Clipboard, pastesSvgPathsAndSaysWhatIsWrong) {
    Driver driver(documentOf({curveOf("cardinal")}));
    driver.settle();
    driver.move(driver.at({0, 0}));
    ImGui::SetClipboardText("M 0 0 C 0 1 1 2 2 2 S 4 1 4 0 Z");
    driver.key(Key::v, withControl);
    ASSERT_EQ(driver.session.document().curves.size(), 2U);
    EXPECT_EQ(driver.curve().family, "bezier-spline");
    EXPECT_TRUE(driver.curve().closed);
    ImGui::SetClipboardText("M 0 0 C 1 2 three");
    driver.key(Key::v, withControl);
    EXPECT_EQ(driver.session.document().curves.size(), 2U);
    ASSERT_TRUE(driver.session.notice);
    EXPECT_TRUE(driver.session.notice->isProblem);
}

TEST(Hands, aCopyDoesNotHideWhatItWasMadeFrom) {
    Hand hand(documentOf({curveOf("b-spline")}));
    hand.key(Key::d, withControl);
    ASSERT_EQ(hand.session.document().curves.size(), 2U);
    EXPECT_NE(hand.place(0, 0), hand.place(0, 1));
    EXPECT_EQ(hand.session.view.activeCurve, 1U);
    EXPECT_EQ(hand.steps(), 1);
}

TEST(Hands, twoEndsAreJoinedAndACurveIsSplit) {
    Curve other = curveOf("bezier-spline");
    for (std::size_t i = 0; i < other.points.size(); ++i) {
        other.points.set(i, other.points.at(i) + Point{8, 0});
    }
    Hand hand(documentOf({curveOf("bezier-spline"), other}));
    hand.session.view.selection = {{0, 6}, {1, 0}};
    hand.key(Key::j, withControl);
    ASSERT_EQ(hand.session.document().curves.size(), 1U);
    EXPECT_EQ(hand.curve().points.size(), 16U) << "a leg leads from end to end";
    hand.session.view.selection = {{0, 6}};
    hand.key(Key::k, withControl);
    EXPECT_EQ(hand.session.document().curves.size(), 2U);
    hand.key(Key::z, withControl);
    hand.key(Key::z, withControl);
    EXPECT_EQ(hand.session.document().curves.size(), 2U);
    EXPECT_EQ(hand.curve(1), other);
}

TEST(Hands, oneKeyGoesThroughTheKindsOfHandles) {
    Hand hand(documentOf({curveOf("bezier-spline")}));
    hand.session.view.selection = {{0, 3}};
    std::set<HandleMode> seen;
    for (int i = 0; i < 4; ++i) {
        const HandleMode before = modeOf(hand.session.document().curves[0], 3);
        hand.key(Key::m);
        const HandleMode now = modeOf(hand.session.document().curves[0], 3);
        EXPECT_EQ(now, nextHandleMode(before));
        EXPECT_TRUE(hand.session.notice) << "it says which";
        seen.insert(now);
    }
    EXPECT_EQ(seen.size(), 4U);
}

} // namespace
} // namespace splineloft::ui
