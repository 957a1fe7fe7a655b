// The layer of frames: it goes on and off, and its arrows point where the frames do.
#include "driver.h"
#include "hand.h"

#include "ui/canvas/frame_arrows.h"
#include "ui/commands.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace splineloft::ui {
namespace {

Scene arrowsOf(const Session& session) {
    Scene scene;
    drawFrames(scene, *session.active(), session.view, {session.view.camera, session.canvas}, 1);
    return scene;
}

std::vector<SceneStroke> strokesOf(const Scene& scene, Role role, int which) {
    std::vector<SceneStroke> found;
    for (const auto& stroke : scene.strokes) {
        if (stroke.ink.role == role && stroke.ink.index == which) {
            found.push_back(stroke);
        }
    }
    return found;
}

TEST(FrameArrows, goOnAndOffByTheKeyTheRailAndTheMenu) {
    Driver driver(documentOf({curveOf("cardinal")}));
    const auto drawn = [&] { return driver.result.pictures.front().signs.size(); };
    driver.settle();
    const auto without = drawn();
    driver.key(Key::r);
    EXPECT_TRUE(driver.session.view.layers.frames);
    EXPECT_GT(drawn(), without + 40) << "two arrows at each of 24 beads";
    driver.click(Widget{"tools", {"∟"}});
    EXPECT_FALSE(driver.session.view.layers.frames);
    EXPECT_EQ(drawn(), without);
    commandNamed("view.frames").run(driver.session);
    EXPECT_TRUE(driver.session.view.layers.frames);
    EXPECT_EQ(driver.steps(), 0);
}

TEST(FrameArrows, inThePlaneAreTangentAndLeftNormal) {
    Driver driver(documentOf({curveOf("natural")}));
    driver.session.view.beads = 9;
    driver.session.view.cursor = {2, 0.3};
    const Scene scene = arrowsOf(driver.session);
    EXPECT_EQ(strokesOf(scene, Role::frame, 0).size(), 9U);
    EXPECT_EQ(strokesOf(scene, Role::frame, 1).size(), 9U);
    EXPECT_TRUE(strokesOf(scene, Role::frame, 2).empty());
    const auto t = strokesOf(scene, Role::cursorFrame, 0).at(0).points;
    const auto n = strokesOf(scene, Role::cursorFrame, 1).at(0).points;
    const Jet jet = driver.session.active()->pieces().jet({2, 0.3});
    const double speed = norm(jet.first);
    EXPECT_NEAR((t[1].x - t[0].x) / std::hypot(t[1].x - t[0].x, t[1].y - t[0].y),
                jet.first[0] / speed, 1e-12);
    const ScreenPoint a{t[1].x - t[0].x, t[1].y - t[0].y}, b{n[1].x - n[0].x, n[1].y - n[0].y};
    EXPECT_NEAR(a.x * b.x + a.y * b.y, 0, 1e-9);
    EXPECT_LT(a.x * b.y - a.y * b.x, 0) << "to the left, where y points down";
}

TEST(FrameArrows, inSpaceAreThreeAsShortAsTheyAreSeen) {
    Driver driver(documentOf({curveOf("natural", 3)}));
    const Scene scene = arrowsOf(driver.session);
    double longest = 0;
    for (int which = 0; which < 3; ++which) {
        for (const auto& stroke : strokesOf(scene, Role::frame, which)) {
            const auto& p = stroke.points;
            longest = std::max(longest, std::hypot(p[1].x - p[0].x, p[1].y - p[0].y));
        }
    }
    EXPECT_GT(longest, 10);
    EXPECT_LE(longest, 26 + 1e-9);
    EXPECT_FALSE(strokesOf(scene, Role::frame, 2).empty());
}

TEST(FrameArrows, areDrawnForEveryCurveThereIs) {
    Driver driver;
    Curve same = curveOf("cardinal", 3), many = curveOf("cardinal", 3);
    for (std::size_t i = 0; i < 7; ++i) {
        same.points.set(i, Point{1, 2, 3});
    }
    for (int i = 0; i < 20'000; ++i) {
        many.points.append(Point{std::sin(0.1 * i), std::cos(0.13 * i), 0.001 * i});
    }
    for (const Curve& curve : {same, many, curveOf("linear", 1), curveOf("nurbs", 2),
                               curveOf("hermite", 6), curveOf("cardinal", true)}) {
        driver.session.opened(documentOf({curve}), "");
        driver.session.view.layers.frames = true;
        driver.frames(2);
        EXPECT_EQ(driver.faults(), "") << curve.family;
    }
}

} // namespace
} // namespace splineloft::ui
