// Whole frames: the canvas under real events, hints and notices, playing.
#include "driver.h"
#include "hand.h"

#include "core/spline/catalog.h"
#include "ui/canvas/gizmo.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

namespace splineloft::ui {
namespace {

TEST(Canvas, aDragThatArrivesInOneGoIsADrag) {
    Driver driver(plain());
    const ScreenPoint from = driver.atPoint(3);
    const ScreenPoint to = driver.at({2, 2});
    for (const InputEvent& event :
         {InputEvent(PointerMoved{from.x, from.y}),
          InputEvent(PointerButton{Button::left, true, {}}), InputEvent(PointerMoved{to.x, to.y}),
          InputEvent(PointerButton{Button::left, false, {}}),
          InputEvent(PointerMoved{from.x, from.y})}) {
        driver.queue.push(event);
    }
    driver.settle();
    EXPECT_EQ(driver.curve().points.at(3), (Point{2, 2}));
    EXPECT_EQ(driver.steps(), 1);
}

TEST(Canvas, aDragGoesOnOverThePanels) {
    Driver driver(plain());
    driver.press(driver.atPoint(3));
    driver.move({1200, 300}); // the inspector
    EXPECT_TRUE(driver.session.history.previewing());
    driver.move({driver.at({2, 2})});
    driver.release();
    EXPECT_EQ(driver.curve().points.at(3), (Point{2, 2}));
}

TEST(Canvas, aDoubleClickOnTheCurveInserts) {
    Driver driver(plain());
    const Point p = driver.session.active()->pieces().position({2, 0.4});
    driver.doubleClick(driver.at({p[0], p[1]}));
    EXPECT_EQ(driver.curve().points.size(), 8U);
    EXPECT_EQ(driver.steps(), 1);
}

TEST(Canvas, theWheelZoomsAtThePointer) {
    Driver driver(plain());
    const ScreenPoint at{333, 222};
    driver.move(at);
    const Viewport before{driver.session.view.camera, driver.session.canvas};
    for (const double notches : {1.0, 3.0, -2.5, 0.1}) {
        driver.send(WheelTurned{0, notches, {}});
        const Viewport now{driver.session.view.camera, driver.session.canvas};
        const PlanePoint there = now.toPlane(at);
        EXPECT_LE(std::hypot(there.x - before.toPlane(at).x, there.y - before.toPlane(at).y),
                  1e-12);
    }
    EXPECT_NE(driver.session.view.camera.pixelsPerUnit, before.camera.pixelsPerUnit);
    driver.move({1200, 300});
    const Camera camera = driver.session.view.camera;
    driver.send(WheelTurned{0, 1, {}});
    EXPECT_EQ(driver.session.view.camera, camera) << "over the inspector it scrolls that";
}

TEST(Canvas, fitShowsEverythingWhereverItIs) {
    for (const Point& away : {Point{0, 0}, Point{5e3, -7e5}, Point{-3.25, 1}, Point{9e8, 9e8}}) {
        Curve curve = curveOf("cardinal");
        for (std::size_t i = 0; i < curve.points.size(); ++i) {
            curve.points.set(i, sevenPoints().at(i) + away);
        }
        Driver driver(documentOf({curve}));
        driver.send(PointerMoved{300, 300});
        driver.send(WheelTurned{0, 30, {}});
        driver.key(Key::f);
        for (std::size_t i = 0; i < 7; ++i) {
            EXPECT_TRUE(driver.session.canvas.contains(driver.atPoint(i))) << "P" << i << away[0];
        }
        EXPECT_EQ(driver.faults(), "");
    }
}

TEST(Canvas, everyKeyForItFits) {
    Driver driver(documentOf({curveOf("cardinal")}));
    driver.settle();
    for (const auto& [key, held] : {std::pair{Key::f, Modifiers{}},
                                    {Key::home, Modifiers{}},
                                    {Key::digit0, Modifiers{.control = true}}}) {
        driver.send(PointerMoved{300, 300});
        driver.send(WheelTurned{0, 30, {}});
        driver.settle();
        ASSERT_FALSE(driver.session.canvas.contains(driver.atPoint(6))) << "the view was elsewhere";
        driver.key(key, held);
        for (std::size_t i = 0; i < 7; ++i) {
            EXPECT_TRUE(driver.session.canvas.contains(driver.atPoint(i))) << "P" << i;
        }
    }
}

TEST(Canvas, fitBeginsWithThePointItself) {
    Curve curve = curveOf("linear");
    curve.points = {{0, 0}, {-5, -5}, {-4, -6}};
    Driver driver(documentOf({curve}));
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_TRUE(driver.session.canvas.contains(driver.atPoint(i))) << "P" << i;
    }
}

TEST(Canvas, pointsAsCloseAsDoublesAllowAreDrawnAllTheSame) {
    for (const double far : {1.0, 1e3, 1e6, 1e9 - 1}) {
        Curve curve = curveOf("cardinal");
        curve.points = {{far, far}, {std::nextafter(far, 2 * far), far}, {far, far}};
        Driver driver(documentOf({curve}));
        driver.move({333, 222});
        for (int i = 0; i < 40; ++i) {
            driver.send(WheelTurned{0, 10, {}});
        }
        EXPECT_EQ(driver.faults(), "") << far;
        for (int i = 0; i < 60; ++i) {
            driver.send(WheelTurned{0, -10, {}});
        }
        EXPECT_EQ(driver.faults(), "") << far;
    }
}

TEST(Canvas, losingTheFocusInMidDragRestores) {
    Driver driver(plain());
    driver.press(driver.atPoint(3));
    driver.move(driver.at({2, 2}));
    driver.send(FocusChanged{false});
    driver.release(); // the toolkit's own
    EXPECT_EQ(driver.curve().points, sevenPoints());
    EXPECT_EQ(driver.steps(), 0);
    driver.send(FocusChanged{true});
    driver.drag(driver.atPoint(3), driver.at({2, 2}));
    EXPECT_EQ(driver.steps(), 1);
}

TEST(Canvas, escapeInMidDragRestoresWhateverElseIsHeld) {
    for (const auto& [modifier, held] :
         {std::pair{Key::leftControl, withControl}, std::pair{Key::leftShift, withShift}}) {
        Driver driver(plain());
        driver.press(driver.atPoint(3));
        driver.hold(modifier);
        driver.move(driver.at({2, 2}));
        ASSERT_NE(driver.curve().points, sevenPoints());
        driver.key(Key::escape, held);
        EXPECT_EQ(driver.curve().points, sevenPoints());
        driver.release();
        driver.letGo(modifier);
        EXPECT_EQ(driver.curve().points, sevenPoints());
        EXPECT_EQ(driver.steps(), 0);
    }
}

TEST(Hints, ofAGripEndWhereThePointerLeavesTheCanvas) {
    Driver driver(plain());
    driver.session.view.selection = {{0, 1}, {0, 3}, {0, 4}};
    driver.frames(1);
    const Viewport viewport{driver.session.view.camera, driver.session.canvas};
    const auto gizmo = gizmoOf(driver.session.document(), driver.session.view, viewport, 1);
    ASSERT_TRUE(gizmo);
    driver.move(gizmo->placeOf(Grip{0, 0}));
    ASSERT_NE(driver.hint().find("turn"), std::string::npos) << driver.hint();
    driver.move({driver.screen.width - 40.0, 300});
    EXPECT_EQ(driver.hint().find("turn"), std::string::npos) << driver.hint();
}

TEST(Hints, sayWhatTheMouseWouldDo) {
    Driver driver(plain());
    std::map<std::string, std::string> hints;
    driver.move(driver.at({-0.5, -1.75}));
    hints["nothing"] = driver.hint();
    driver.move(driver.atPoint(3));
    hints["point"] = driver.hint();
    EXPECT_NE(driver.hint().find("P₃"), std::string::npos) << driver.hint();
    const Point p = driver.session.active()->pieces().position({2, 0.4});
    driver.move(driver.at({p[0], p[1]}));
    hints["curve"] = driver.hint();
    driver.press(driver.at({p[0], p[1]}));
    hints["sliding"] = driver.hint();
    driver.release();
    driver.press(driver.atPoint(3));
    hints["dragging"] = driver.hint();
    driver.release();
    driver.press(driver.at({-0.5, -1.75}));
    hints["boxing"] = driver.hint();
    driver.release();
    driver.press(driver.at({-0.5, -1.75}), Button::middle);
    hints["panning"] = driver.hint();
    driver.release(Button::middle);
    driver.key(Key::p);
    hints["pen"] = driver.hint();
    driver.press(driver.at({-0.5, -1.75}));
    hints["placing"] = driver.hint();
    driver.release();
    for (const auto& [a, hintA] : hints) {
        EXPECT_FALSE(hintA.empty()) << a;
        for (const auto& [b, hintB] : hints) {
            EXPECT_TRUE(a == b || hintA != hintB) << a << " and " << b << " say the same";
        }
    }
}

TEST(Hints, aNoticeStaysUntilTheNextPress) {
    Driver driver(plain());
    driver.session.complain("the disk is full");
    driver.move({400, 300});
    driver.frames(200);
    EXPECT_TRUE(driver.session.notice) << "it can be read in peace";
    driver.press(driver.at({-0.5, -1.75}));
    EXPECT_FALSE(driver.session.notice);
    driver.release();
    driver.session.say("Saved");
    driver.key(Key::l);
    EXPECT_FALSE(driver.session.notice);
}

TEST(Hints, aNoticeTooLongForItsLineIsShownWholeAndBlocksNoHand) {
    Driver driver(plain(), {800, 600, 1});
    driver.session.view.strip = 0;
    driver.session.view.layers.basis = false;
    driver.frames(2);
    driver.move({300, 300});
    driver.key(Key::f);
    const ScreenPoint low{driver.session.canvas.left + 40, driver.session.canvas.bottom() - 15};
    driver.session.complain(std::string(40, 'x') + " is not possible: " + std::string(60, 'y') +
                            " right would be " + std::string(60, 'z'));
    driver.frames(3);
    driver.press(low);
    EXPECT_TRUE(std::holds_alternative<Boxing>(driver.session.gesture)) << "hands reach through";
    driver.release();
}

/// Where the cursor is after each of so many equal times.
std::vector<Spot> played(Driver& driver, Even pace, int steps) {
    driver.session.view.pace = pace;
    driver.session.view.duration = 10;
    driver.session.view.cursor = {0, 0};
    driver.session.view.playing = true;
    std::vector<Spot> spots;
    for (int i = 0; i < steps; ++i) {
        driver.frames(1, 0.05);
        spots.push_back(driver.session.view.cursor);
    }
    return spots;
}

TEST(Play, runsAtConstantSpeedOrEvenlyInTheParameter) {
    Driver driver(documentOf({curveOf("catmull-rom")}));
    const auto& study = *driver.session.active();
    const auto byLength = played(driver, Even::length, 150);
    const double way = study.lengths().total() * 0.05 / 10;
    for (std::size_t i = 1; i < byLength.size(); ++i) {
        EXPECT_NEAR(study.lengths().upTo(byLength[i]) - study.lengths().upTo(byLength[i - 1]), way,
                    1e-6 * way)
            << "step " << i;
    }
    const auto byParameter = played(driver, Even::parameter, 150);
    const auto& knots = study.pieces().knots();
    const double part = (knots.end() - knots.start()) * 0.05 / 10;
    for (std::size_t i = 1; i < byParameter.size(); ++i) {
        EXPECT_NEAR(knots.parameter(byParameter[i]) - knots.parameter(byParameter[i - 1]), part,
                    1e-9)
            << "step " << i;
    }
}

TEST(Play, beginsAgainAtTheEnd) {
    Driver driver(plain());
    const auto spots = played(driver, Even::length, 230); // 11.5 of 10 seconds
    EXPECT_LT(driver.session.active()->pieces().knots().parameter(spots.back()),
              driver.session.active()->pieces().knots().parameter(spots[150]));
    EXPECT_TRUE(driver.session.view.playing);
    EXPECT_TRUE(driver.result.animating);
}

TEST(Play, aLongSleepBeforeItIsNoLeap) {
    Driver driver(plain());
    driver.session.view.duration = 6;
    driver.session.view.cursor = {0, 0};
    driver.queue.push(KeyChanged{Key::space, true, false, {}});
    driver.frames(1);
    driver.queue.push(KeyChanged{Key::space, false, false, {}}); // a tap ends when it is let go
    driver.frames(1, 3600);
    const auto& lengths = driver.session.active()->lengths();
    EXPECT_LE(lengths.upTo(driver.session.view.cursor), lengths.total() * 0.1 / 6 * 1.0001);
    EXPECT_TRUE(driver.session.view.playing);
}

TEST(Play, stopsWhereThereIsNothingToPlay) {
    Driver driver(plain());
    driver.key(Key::space);
    ASSERT_TRUE(driver.result.animating);
    driver.key(Key::del, withShift);
    driver.frames(2);
    EXPECT_FALSE(driver.result.animating);
    driver.key(Key::space);
    EXPECT_FALSE(driver.result.animating) << "idle means idle";
}

TEST(Play, whereAllPointsCoincideItStaysThere) {
    for (const auto& family : catalog()) {
        Curve curve = curveOf(family.id);
        for (std::size_t i = 0; i < curve.points.size(); ++i) {
            curve.points.set(i, {1, 1});
        }
        Driver driver(documentOf({curve}));
        for (const Even pace : {Even::length, Even::parameter}) {
            played(driver, pace, 20);
            EXPECT_EQ(driver.faults(), "") << family.id;
        }
    }
}

} // namespace
} // namespace splineloft::ui
