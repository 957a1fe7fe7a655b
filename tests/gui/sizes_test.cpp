// Sizes: edges of panels that are dragged, the scale of the interface, monitors of other scales,
// and the canvas before an audience.
#include "driver.h"
#include "hand.h"

#include "ui/commands.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace splineloft::ui {
namespace {

/// The middle of an edge between panels.
ScreenPoint besideInspector(const Driver& driver) {
    return {driver.session.canvas.right(), driver.session.canvas.top + 200};
}
ScreenPoint aboveStrip(const Driver& driver) {
    return {driver.session.canvas.left + 200, driver.session.canvas.bottom()};
}

TEST(Splitters, aDragMovesTheEdgeOfTheInspector) {
    Driver driver(plain());
    const auto edge = besideInspector(driver);
    driver.move(edge);
    driver.frames(1);
    EXPECT_EQ(driver.result.pointer, PointerShape::resizeAcross);
    driver.drag(edge, {edge.x - 70, edge.y + 10});
    EXPECT_NEAR(driver.session.view.inspector, usualInspector + 70, 1);
    driver.frames(1);
    EXPECT_NEAR(driver.session.canvas.right(), edge.x - 70, 1);
    EXPECT_EQ(driver.steps(), 0);
}

TEST(Splitters, aDragMovesTheEdgeOfTheStrip) {
    Driver driver(plain());
    const auto edge = aboveStrip(driver);
    driver.move(edge);
    driver.frames(1);
    EXPECT_EQ(driver.result.pointer, PointerShape::resizeAlong);
    driver.drag(edge, {edge.x, edge.y - 55});
    EXPECT_NEAR(driver.session.view.strip, usualStrip + 55, 1);
}

TEST(Splitters, aDoubleClickPutsThemBack) {
    Driver driver(plain());
    driver.session.view.inspector = 400;
    driver.session.view.strip = 300;
    driver.frames(2);
    driver.doubleClick(besideInspector(driver));
    EXPECT_EQ(driver.session.view.inspector, usualInspector);
    driver.frames(2);
    driver.doubleClick(aboveStrip(driver));
    EXPECT_EQ(driver.session.view.strip, usualStrip);
}

TEST(Splitters, theCanvasKeepsItsRoomWhateverIsDragged) {
    for (const Screen screen : {Screen{800, 600, 1}, Screen{1280, 800, 1}, Screen{2560, 1440, 2}}) {
        Driver driver(plain(), screen);
        driver.drag(besideInspector(driver), {-50, 300});
        driver.drag(aboveStrip(driver), {300, -50});
        driver.frames(2);
        const auto& canvas = driver.session.canvas;
        EXPECT_GE(canvas.width, 0.4 * screen.width) << screen.width;
        EXPECT_GE(canvas.height, 150 * screen.scale) << screen.width;
        driver.drag(besideInspector(driver), {3000, 300});
        driver.frames(2);
        EXPECT_GE(driver.session.view.inspector, 200) << "it can be found again";
        driver.drag(aboveStrip(driver), {300, 3000});
        driver.frames(2);
        EXPECT_GE(driver.session.view.strip, 100);
        EXPECT_EQ(driver.faults(), "");
    }
}

/// Where the middle of the window's content is and how large a unit of it is in design pixels.
struct Seen {
    PlanePoint centre;
    double unit;
};
Seen seen(const Driver& driver) {
    return {driver.session.view.camera.centre,
            driver.session.view.camera.pixelsPerUnit / driver.session.scale};
}

TEST(Scale, growsAndShrinksEverythingInSteps) {
    Driver driver(plain());
    const Seen before = seen(driver);
    driver.key(Key::equal, withControl);
    driver.frames(2);
    EXPECT_EQ(driver.session.view.interfaceScale, 1.1);
    EXPECT_EQ(driver.session.scale, 1.1);
    EXPECT_NEAR(seen(driver).unit, before.unit, 1e-9) << "the plane grows along";
    EXPECT_EQ(seen(driver).centre, before.centre);
    driver.key(Key::minus, withControl);
    driver.key(Key::minus, withControl);
    driver.frames(2);
    EXPECT_EQ(driver.session.scale, 0.9);
    for (int i = 0; i < 20; ++i) {
        driver.key(Key::minus, withControl);
    }
    EXPECT_EQ(driver.session.view.interfaceScale, 0.75);
    EXPECT_FALSE(commandNamed("view.smaller").possible(driver.session));
    for (int i = 0; i < 20; ++i) {
        driver.key(Key::equal, withControl);
    }
    EXPECT_EQ(driver.session.view.interfaceScale, 2);
    commandNamed("view.usualSize").run(driver.session);
    driver.frames(2);
    EXPECT_EQ(driver.session.scale, 1);
    EXPECT_NEAR(seen(driver).unit, before.unit, 1e-9);
    EXPECT_EQ(driver.steps(), 0);
}

TEST(Scale, neverLeavesThePanelsWithoutRoom) {
    for (const double scale : {1.0, 1.5, 2.0}) {
        Driver driver(plain(), {800, 600, scale});
        driver.session.view.interfaceScale = 2;
        driver.frames(2);
        EXPECT_LE(driver.session.scale, 800.0 / 640);
        EXPECT_EQ(driver.session.view.interfaceScale, 2) << "in a larger window it counts again";
        driver.screen = {2560, 1440, scale};
        driver.frames(2);
        EXPECT_EQ(driver.session.scale, std::min(2 * scale, 3.5));
    }
}

TEST(Scale, onAMonitorOfAnotherScaleTheSameIsSeen) {
    Driver driver(plain(), {1280, 800, 1});
    const Seen before = seen(driver);
    const ScreenPoint point = driver.atPoint(3);
    driver.screen = {2560, 1600, 2};
    driver.frames(2);
    EXPECT_EQ(driver.session.scale, 2);
    EXPECT_NEAR(seen(driver).unit, before.unit, 1e-9);
    EXPECT_NEAR(driver.atPoint(3).x, 2 * point.x, 1e-6);
    EXPECT_NEAR(driver.atPoint(3).y, 2 * point.y, 1e-6);
    driver.drag(driver.atPoint(3), driver.at({2, 2}));
    EXPECT_EQ(driver.curve().points.at(3), (Point{2, 2})) << "hands hit what is drawn";
}

class Presenting : public testing::Test {
  protected:
    /// Whether all control points are on the canvas.
    bool allSeen() const {
        for (std::size_t i = 0; i < driver.curve().points.size(); ++i) {
            if (!driver.session.canvas.contains(driver.atPoint(i))) {
                return false;
            }
        }
        return true;
    }

    Driver driver{plain()};
};

TEST_F(Presenting, takesThePanelsAwayAndEverythingGetsLarger) {
    driver.key(Key::f11);
    driver.frames(2);
    EXPECT_TRUE(driver.session.view.presenting);
    EXPECT_TRUE(driver.result.fullScreen);
    EXPECT_DOUBLE_EQ(driver.session.scale, 1.6);
    EXPECT_EQ(driver.session.canvas.left, 0);
    EXPECT_EQ(driver.session.canvas.top, 0);
    EXPECT_EQ(driver.session.canvas.width, driver.screen.width);
    EXPECT_FALSE(driver.has(inInspector("##family")));
    EXPECT_FALSE(driver.has(Widget{"tools", {"✎"}}));
    EXPECT_TRUE(allSeen());
}

TEST_F(Presenting, strokesAndPointsGetLarger) {
    const auto largest = [&] {
        double stroke = 0, sign = 0;
        for (const auto& picture : driver.result.pictures) {
            for (const auto& vertex : picture.ribbons) {
                stroke = std::max(stroke, double(vertex.halfWidth));
            }
            for (const auto& pieces : picture.pieces) {
                stroke = std::max(stroke, pieces.style.width / 2.0);
            }
            for (const auto& one : picture.signs) {
                sign = std::max(sign, double(one.radius));
            }
        }
        return std::pair{stroke, sign};
    };
    driver.settle();
    const auto [stroke, sign] = largest();
    ASSERT_GT(stroke, 0);
    driver.key(Key::f11);
    driver.frames(2);
    const auto [thick, large] = largest();
    EXPECT_GE(thick, 1.5 * stroke);
    EXPECT_GE(large, 1.5 * sign);
}

TEST_F(Presenting, leavesByTheSameKeyOrEscapeAndEverythingIsAsBefore) {
    for (const Key leaving : {Key::f11, Key::escape}) {
        driver.session.view.camera = {{0.25, -0.5}, 91};
        driver.frames(1);
        const Camera camera = driver.session.view.camera;
        const ScreenRect canvas = driver.session.canvas;
        driver.key(Key::f11);
        driver.screen = {1920, 1080, 1}; // the monitor, some frames later
        driver.frames(2);
        driver.send(WheelTurned{0, 3, {}});
        driver.key(leaving);
        driver.frames(1);
        driver.screen = {1280, 800, 1};
        driver.frames(2);
        EXPECT_FALSE(driver.session.view.presenting);
        EXPECT_FALSE(driver.result.fullScreen);
        EXPECT_EQ(driver.session.canvas, canvas);
        EXPECT_EQ(driver.session.view.camera.centre, camera.centre);
        EXPECT_NEAR(driver.session.view.camera.pixelsPerUnit, camera.pixelsPerUnit, 1e-9);
    }
}

TEST_F(Presenting, whatWasSeenStaysSeenWhateverTheMonitor) {
    for (const Screen monitor : {Screen{1024, 768, 1}, Screen{1920, 1080, 1}, Screen{800, 600, 1},
                                 Screen{3840, 2160, 2}}) {
        driver.screen = {1280, 800, monitor.scale};
        driver.key(Key::f);
        driver.frames(2);
        ASSERT_TRUE(allSeen());
        driver.key(Key::f11);
        driver.frames(1);
        driver.screen = monitor;
        driver.frames(2);
        EXPECT_TRUE(allSeen()) << monitor.width;
        driver.key(Key::f11);
        driver.frames(2);
    }
}

TEST_F(Presenting, pointsAreStillDraggedAndOneStepEach) {
    driver.key(Key::f11);
    driver.frames(2);
    driver.drag(driver.atPoint(3), driver.at({2, 2}));
    EXPECT_EQ(driver.curve().points.at(3), (Point{2, 2}));
    EXPECT_EQ(driver.steps(), 1);
}

TEST_F(Presenting, escapeEndsTheDragBeforeTheShow) {
    driver.key(Key::f11);
    driver.frames(2);
    driver.press(driver.atPoint(3));
    driver.move(driver.at({2, 2}));
    driver.key(Key::escape);
    EXPECT_TRUE(driver.session.view.presenting);
    driver.release();
    driver.key(Key::escape);
    EXPECT_FALSE(driver.session.view.presenting);
}

TEST_F(Presenting, anotherDocumentIsFittedAfterwards) {
    driver.key(Key::f11);
    Curve far = curveOf("cardinal");
    for (std::size_t i = 0; i < far.points.size(); ++i) {
        far.points.set(i, far.points.at(i) + Point{5000, 0});
    }
    driver.session.opened(documentOf({far}), "");
    driver.frames(2);
    EXPECT_TRUE(driver.session.view.presenting);
    EXPECT_TRUE(allSeen());
    driver.key(Key::f11);
    driver.frames(2);
    EXPECT_TRUE(allSeen());
}

TEST(Grid, itsLinesAndNumbersCanBeHidden) {
    Driver driver(plain());
    const auto strokes = [&] { return driver.result.pictures.front().ribbons.size(); };
    const auto all = strokes();
    driver.key(Key::g, withShift);
    EXPECT_LT(strokes(), all);
    driver.key(Key::g, withShift);
    EXPECT_EQ(strokes(), all);
    driver.key(Key::n, withShift);
    EXPECT_EQ(strokes(), all) << "numbers are no lines";
    EXPECT_FALSE(driver.session.view.layers.gridNumbers);
}

} // namespace
} // namespace splineloft::ui
