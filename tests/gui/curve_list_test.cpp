// The list of curves: names, colours, eyes and locks, and what these mean on the canvas.
#include "driver.h"
#include "hand.h"

#include "core/document/curve_edits.h"
#include "core/document/edits.h"
#include "ui/canvas/pick.h"
#include "ui/commands.h"
#include "ui/theme.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace splineloft::ui {
namespace {

/// Three curves above one another, 4 units apart.
Document threeCurves() {
    Document document;
    for (int i = 0; i < 3; ++i) {
        Curve curve = curveOf("cardinal");
        curve.name = std::string(1, static_cast<char>('a' + i));
        for (std::size_t k = 0; k < curve.points.size(); ++k) {
            curve.points.set(k, curve.points.at(k) + Point{0, 4.0 * i});
        }
        document.curves.push_back(std::make_shared<Curve>(curve));
    }
    return document;
}

Widget inRow(int row, const std::string& part) {
    return {"inspector", {"curves", row, part}};
}

class CurveListTest : public testing::Test {
  protected:
    std::string names() const {
        std::string all;
        for (const auto& entry : driver.session.document().curves) {
            all += entry->name;
        }
        return all;
    }
    const Look& look(std::size_t i) const { return driver.session.document().curves[i].look; }
    ScreenPoint atPointOf(std::size_t curve, std::size_t index) const {
        return driver.at(controlPlaces(*driver.session.document().curves[curve], {})[index]);
    }
    bool isDrawn(Colour colour) const {
        const auto& signs = driver.result.pictures.front().signs;
        const auto& ribbons = driver.result.pictures.front().ribbons;
        return std::ranges::count(signs, colour, &Sign::fill) +
                   std::ranges::count(ribbons, colour, &RibbonVertex::colour) >
               0;
    }

    Driver driver{threeCurves()};
};

TEST_F(CurveListTest, isThereAsSoonAsThereIsOneCurve) {
    driver.session.opened(documentOf({curveOf("cardinal")}), "");
    driver.frames(2);
    EXPECT_TRUE(driver.has(inRow(0, "##name")));
    EXPECT_FALSE(driver.has(inRow(1, "##name")));
}

TEST_F(CurveListTest, aClickOnANameTurnsToThatCurve) {
    driver.click(inRow(2, "##name"));
    EXPECT_EQ(driver.session.view.activeCurve, 2U);
    EXPECT_EQ(driver.steps(), 0);
}

TEST_F(CurveListTest, theEyeHidesACurveFromTheCanvasAndFromHands) {
    driver.click(inRow(1, "eye"));
    EXPECT_FALSE(look(1).visible);
    EXPECT_EQ(driver.steps(), 1);
    EXPECT_EQ(driver.session.history.undoLabel(), "Hide b");
    driver.click(atPointOf(1, 3));
    EXPECT_EQ(driver.session.view.activeCurve, 0U) << "it cannot be picked";
    EXPECT_TRUE(driver.session.view.selection.empty());
    driver.drag(atPointOf(1, 3), driver.at({9, 9}));
    EXPECT_EQ(driver.steps(), 1);
    driver.key(Key::z, withControl);
    EXPECT_TRUE(look(1).visible);
    driver.click(atPointOf(1, 3));
    EXPECT_EQ(driver.session.view.activeCurve, 1U);
}

TEST_F(CurveListTest, aHiddenCurveIsNotDrawnNorFitted) {
    Document document = threeCurves();
    Look coloured;
    coloured.colour = 7;
    document = setLook(document, 2, coloured);
    driver.session.opened(document, "");
    driver.frames(2);
    const Colour colour = colourOf(themeOf(ThemeKind::dark), {Role::curve, 7});
    ASSERT_TRUE(isDrawn(colour));
    const double unit = driver.session.view.camera.pixelsPerUnit;
    driver.click(inRow(2, "eye"));
    driver.frames(1);
    const auto& ribbons = driver.result.pictures.front().ribbons;
    EXPECT_EQ(std::ranges::count(ribbons, colour, &RibbonVertex::colour), 0);
    driver.move({300, 300});
    driver.key(Key::f);
    EXPECT_GT(driver.session.view.camera.pixelsPerUnit, unit) << "two curves fill the canvas";
}

TEST_F(CurveListTest, hidingTheActiveCurveLeavesNothingOfItOnTheCanvas) {
    driver.session.view.selection = {{0, 2}};
    driver.click(inRow(0, "eye"));
    driver.frames(1);
    EXPECT_TRUE(driver.session.view.selection.empty());
    EXPECT_FALSE(isDrawn(colourOf(themeOf(ThemeKind::dark), {Role::tip})))
        << "neither curve nor ladder";
    EXPECT_EQ(driver.faults(), "");
}

TEST_F(CurveListTest, aLockedCurveIsSeenAndNoHandChangesIt) {
    const Document before = driver.session.document();
    driver.session.view.selection = {{0, 2}};
    driver.click(inRow(0, "lock"));
    ASSERT_TRUE(look(0).locked);
    EXPECT_TRUE(driver.session.view.selection.empty());
    ASSERT_EQ(driver.steps(), 1);
    driver.drag(atPointOf(0, 3), driver.at({2, 2}));
    driver.key(Key::a, withControl);
    driver.key(Key::del);
    driver.key(Key::del, withShift);
    driver.key(Key::c);
    driver.key(static_cast<Key>('3'));
    EXPECT_EQ(driver.steps(), 1);
    EXPECT_EQ(*driver.session.document().curves[0], *before.curves[0]);
    driver.drag(driver.middle(slider("tension")), {1200, 300});
    EXPECT_EQ(driver.steps(), 1) << "the inspector's fields are shut";
    driver.click(inRow(0, "lock"));
    EXPECT_FALSE(look(0).locked);
    driver.drag(atPointOf(0, 3), driver.at({2, 2}));
    EXPECT_EQ(driver.steps(), 3);
}

TEST_F(CurveListTest, noEditAtAllGetsPastALock) {
    driver.click(inRow(0, "lock"));
    const Document locked = driver.session.document();
    driver.session.apply({removeCurves(locked, std::array<std::size_t, 1>{0}), Phase::commit, "x"});
    EXPECT_EQ(driver.session.document(), locked);
    ASSERT_TRUE(driver.session.notice);
    EXPECT_NE(driver.session.notice->text.find("locked"), std::string::npos);
    driver.session.apply({moveCurve(locked, 0, 2), Phase::commit, "Reorder"});
    EXPECT_EQ(names(), "bca") << "its place is no part of it";
}

TEST_F(CurveListTest, thePenGoesOnElsewhereThanOnALockedCurve) {
    driver.click(inRow(0, "lock"));
    driver.key(Key::p);
    driver.click(driver.at({-0.5, -1.75}));
    EXPECT_EQ(driver.session.document().curves.size(), 4U);
    EXPECT_EQ(driver.session.document().curves[0]->points.size(), 7U);
}

TEST_F(CurveListTest, aDoubleClickRenames) {
    driver.doubleClick(driver.middle(inRow(1, "##name")));
    ASSERT_TRUE(driver.session.view.renaming);
    driver.frames(2);
    driver.type("hull");
    driver.key(Key::enter);
    EXPECT_EQ(names(), "ahullc");
    EXPECT_FALSE(driver.session.view.renaming);
    EXPECT_EQ(driver.session.history.undoLabel(), "Rename b");
    driver.key(Key::z, withControl);
    EXPECT_EQ(names(), "abc");
}

TEST_F(CurveListTest, f2RenamesTheActiveCurveAndEscapeDoesNot) {
    driver.session.view.activeCurve = 2;
    driver.key(Key::f2);
    driver.frames(3);
    driver.type("keel");
    driver.key(Key::escape);
    driver.frames(1);
    EXPECT_EQ(names(), "abc");
    EXPECT_FALSE(driver.session.view.renaming);
    driver.key(Key::f2);
    driver.frames(3);
    driver.type("keel");
    driver.click(driver.at({-0.5, -1.75}));
    EXPECT_EQ(names(), "abkeel") << "a click elsewhere enters it";
    driver.key(Key::f2);
    driver.frames(3);
    driver.key(Key::backspace);
    driver.key(Key::enter);
    EXPECT_EQ(names(), "abkeel") << "a curve has a name";
}

TEST_F(CurveListTest, coloursAreChosenInALittleWindow) {
    driver.click(inRow(0, "colour"));
    driver.frames(1);
    driver.click(Widget{"##Popup_", {5, "this"}});
    EXPECT_EQ(look(0).colour, 5);
    EXPECT_EQ(driver.session.history.undoLabel(), "Colour a");
    driver.frames(1);
    EXPECT_TRUE(isDrawn(colourOf(themeOf(ThemeKind::dark), {Role::curve, 5})));
}

TEST_F(CurveListTest, draggingARowReorders) {
    driver.session.view.selection = {{0, 2}, {1, 1}};
    const auto from = driver.middle(inRow(0, "##name"));
    const auto to = driver.middle(inRow(2, "##name"));
    driver.drag(from, to);
    EXPECT_EQ(names(), "bca");
    EXPECT_EQ(driver.session.view.activeCurve, 2U) << "the same curve is active";
    EXPECT_EQ(driver.session.view.selection, (Selection{{2, 2}, {0, 1}}));
    EXPECT_EQ(driver.steps(), 1);
    driver.key(Key::z, withControl);
    EXPECT_EQ(names(), "abc");
    EXPECT_EQ(driver.session.view.activeCurve, 0U) << "still the same one";
    EXPECT_EQ(driver.session.view.selection, (Selection{{0, 2}, {1, 1}}));
}

/// Found by the monkey: the inspector looked for the selected points where they were to be.
TEST_F(CurveListTest, reorderingCurvesOfUnlikeLengthsKeepsToWhatThereIs) {
    Document unlike = driver.session.document();
    unlike = insertPoint(unlike, 0, 7, {9, 9});
    unlike = insertPoint(unlike, 0, 8, {10, 9});
    driver.session.apply({unlike, Phase::commit, "Lengthen"});
    driver.session.view.selection = {{0, 7}, {0, 8}};
    driver.drag(driver.middle(inRow(0, "##name")), driver.middle(inRow(2, "##name")));
    EXPECT_EQ(driver.session.view.selection, (Selection{{2, 7}, {2, 8}}));
}

TEST_F(CurveListTest, escapeInMidDragLeavesTheOrder) {
    driver.press(driver.middle(inRow(0, "##name")));
    driver.move(driver.middle(inRow(2, "##name")));
    driver.key(Key::escape);
    driver.release();
    EXPECT_EQ(names(), "abc");
    EXPECT_EQ(driver.steps(), 0);
}

TEST_F(CurveListTest, plusBeginsAnotherCurve) {
    driver.click(inInspector("+ New"));
    EXPECT_EQ(driver.session.view.tool, Tool::newCurve);
    driver.click(driver.at({-0.5, -1.75}));
    EXPECT_EQ(driver.session.document().curves.size(), 4U);
}

TEST_F(CurveListTest, theCommandsDoTheSame) {
    for (const char* id : {"curve.visible", "curve.locked", "curve.colour"}) {
        ASSERT_TRUE(commandNamed(id).possible(driver.session)) << id;
        commandNamed(id).run(driver.session);
    }
    EXPECT_EQ(look(0), (Look{.visible = false, .locked = true, .colour = 1}));
    EXPECT_EQ(driver.steps(), 3);
    EXPECT_FALSE(commandNamed("curve.rename").possible(driver.session)) << "it is locked";
}

TEST(CurveColours, standOutInBothThemes) {
    for (const auto kind : {ThemeKind::dark, ThemeKind::light}) {
        const Theme& theme = themeOf(kind);
        for (int colour = 0; colour <= curveColours; ++colour) {
            for (const auto role : {Role::curve, Role::otherCurve}) {
                EXPECT_GE(contrast(colourOf(theme, {role, colour}), theme.surfaces.canvas), 3)
                    << colour;
            }
            EXPECT_GE(contrast(colourOf(theme, {Role::curve, colour}), theme.surfaces.panel), 3)
                << colour << " as a swatch";
        }
        EXPECT_EQ(theme.controls.size(), static_cast<std::size_t>(curveColours));
    }
}

} // namespace
} // namespace splineloft::ui
