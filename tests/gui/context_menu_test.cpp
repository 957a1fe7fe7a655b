// The menu of the right button on the canvas.
#include "driver.h"
#include "hand.h"

#include "core/spline/catalog.h"
#include "ui/commands.h"
#include "ui/imgui_compat.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace splineloft::ui {
namespace {

const Widget& entry(const char* label) {
    static Widget widget;
    widget = {"##Popup_", {label}};
    return widget;
}

class ContextMenuTest : public testing::Test {
  protected:
    void rightClick(ScreenPoint at) {
        driver.press(at, Button::right);
        driver.release(Button::right);
    }
    ScreenPoint onCurve(std::size_t segment = 2) const {
        const Point p = driver.session.active()->pieces().position({segment, 0.4});
        return driver.at({p[0], p[1]});
    }

    Driver driver{documentOf({curveOf("cardinal")})};
};

TEST_F(ContextMenuTest, overAPointSelectsItFirst) {
    driver.session.view.selection = {{0, 0}, {0, 1}};
    rightClick(driver.atPoint(3));
    ASSERT_TRUE(driver.session.contextMenu);
    EXPECT_EQ(driver.session.contextMenu->context, Context::point);
    EXPECT_EQ(driver.session.view.selection, (Selection{{0, 3}}));
    driver.click(entry("Delete points"));
    EXPECT_EQ(driver.curve().points.size(), 6U);
    EXPECT_FALSE(driver.session.contextMenu);
}

TEST_F(ContextMenuTest, overASelectedPointKeepsTheSelection) {
    driver.session.view.selection = {{0, 0}, {0, 3}};
    rightClick(driver.atPoint(3));
    EXPECT_EQ(driver.session.view.selection.size(), 2U);
    driver.click(entry("Delete points"));
    EXPECT_EQ(driver.curve().points.size(), 5U);
}

TEST_F(ContextMenuTest, healsWhereAPointIsTakenAway) {
    driver.session.opened(documentOf({curveOf("bezier-spline")}), "");
    driver.settle();
    driver.doubleClick(onCurve(1));
    const auto count = driver.curve().points.size();
    rightClick(driver.atPoint(driver.session.view.selection.begin()->index));
    driver.click(entry("Delete and heal"));
    EXPECT_EQ(driver.curve().points.size(), count - 3);
    EXPECT_TRUE(driver.session.history.undoLabel().starts_with("Delete and heal"));
}

TEST_F(ContextMenuTest, setsTheKindOfHandles) {
    driver.session.opened(documentOf({curveOf("bezier-spline")}), "");
    driver.settle();
    rightClick(driver.atPoint(3));
    driver.click(entry("Handles: mirrored"));
    const auto& points = driver.curve().points;
    EXPECT_LE(distance(points.at(4) - points.at(3), points.at(3) - points.at(2)), 1e-12);
}

TEST_F(ContextMenuTest, overACurveInsertsWhereItWasClicked) {
    const auto at = onCurve();
    const PlanePoint place =
        Viewport{driver.session.view.camera, driver.session.canvas}.toPlane(at);
    rightClick(at);
    ASSERT_TRUE(driver.session.contextMenu);
    EXPECT_EQ(driver.session.contextMenu->context, Context::curve);
    driver.click(entry("Insert a point at u"));
    ASSERT_EQ(driver.curve().points.size(), 8U);
    EXPECT_NEAR(driver.curve().points.at(3)[0], place.x, 0.02);
    EXPECT_NEAR(driver.curve().points.at(3)[1], place.y, 0.02);
    EXPECT_EQ(driver.session.view.selection, (Selection{{0, 3}}));
}

TEST_F(ContextMenuTest, overNothingOffersWhatConcernsTheWholeCanvas) {
    rightClick(driver.at({-0.5, -1.75}));
    ASSERT_TRUE(driver.session.contextMenu);
    EXPECT_EQ(driver.session.contextMenu->context, Context::canvas);
    EXPECT_FALSE(driver.has(entry("Delete points")));
    driver.click(entry("Grid"));
    EXPECT_FALSE(driver.session.view.layers.grid);
}

TEST_F(ContextMenuTest, theOtherCurveUnderThePointerBecomesTheActiveOne) {
    Curve other = curveOf("linear");
    for (std::size_t i = 0; i < other.points.size(); ++i) {
        other.points.set(i, other.points.at(i) + Point{0, 3});
    }
    driver.session.opened(documentOf({curveOf("cardinal"), other}), "");
    driver.frames(2);
    const PlanePoint place = controlPlaces(other, {})[2];
    rightClick(driver.at(place));
    EXPECT_EQ(driver.session.view.activeCurve, 1U);
    EXPECT_EQ(driver.session.view.selection, (Selection{{1, 2}}));
}

TEST_F(ContextMenuTest, inMidDragTheRightButtonRestoresAndOpensNothing) {
    driver.press(driver.atPoint(3));
    driver.move(driver.at({2, 2}));
    driver.press(driver.at({2, 2}), Button::right);
    EXPECT_FALSE(driver.session.contextMenu);
    driver.release(Button::right);
    driver.release();
    EXPECT_EQ(driver.curve().points, sevenPoints());
    EXPECT_FALSE(driver.session.contextMenu);
}

TEST_F(ContextMenuTest, escapeAndAClickElsewhereCloseItAndDoNothingElse) {
    driver.session.view.selection = {{0, 0}};
    const auto empty = driver.at({-0.5, -1.75});
    rightClick(empty);
    ASSERT_TRUE(driver.session.contextMenu);
    driver.key(Key::escape);
    EXPECT_FALSE(isPopupOpen());
    EXPECT_FALSE(driver.session.contextMenu);
    EXPECT_EQ(driver.session.view.selection.size(), 1U) << "Esc closed the menu and no more";
    rightClick(empty);
    driver.click({empty.x - 60, empty.y - 60});
    EXPECT_FALSE(driver.session.contextMenu);
    EXPECT_EQ(driver.session.view.selection.size(), 1U);
}

TEST_F(ContextMenuTest, offTheCanvasThereIsNone) {
    rightClick({1200, 300});
    EXPECT_FALSE(driver.session.contextMenu);
}

TEST(Contexts, eachOffersSomething) {
    for (const auto context : {Context::point, Context::curve, Context::canvas}) {
        EXPECT_GE(std::ranges::count_if(commands(),
                                        [&](const Command& command) {
                                            return std::ranges::count(command.contexts, context) >
                                                   0;
                                        }),
                  3);
    }
    for (const auto& command : commands()) {
        EXPECT_FALSE(!command.contexts.empty() && command.menu.empty())
            << command.id << ": the menu of the right button goes by the menus";
    }
}

} // namespace
} // namespace splineloft::ui
