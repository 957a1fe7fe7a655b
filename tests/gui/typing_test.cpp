// Keys pressed while something is typed, or while something stands in front: whose they are.
#include "driver.h"
#include "hand.h"

#include <gtest/gtest.h>

namespace splineloft::ui {
namespace {

/// A driver with one point selected and its x being typed: "2" so far.
class Typing : public testing::Test {
  protected:
    Typing() {
        driver.session.path = "/there/known.json";
        driver.click(driver.atPoint(3));
        driver.click(pointField(3, 0));
        driver.type("2");
    }

    double x(std::size_t curve) const {
        return driver.session.document().curves.at(curve)->points[3][0];
    }

    Driver driver{plain()};
    const double before = x(0);
};

TEST_F(Typing, wordsAreGoneThroughAndDeletedWithoutAWordToTheCanvas) {
    for (const Key key : {Key::backspace, Key::del, Key::left, Key::right, Key::home, Key::end}) {
        driver.key(key, withControl);
        EXPECT_EQ(driver.curve().points, sevenPoints());
        EXPECT_EQ(driver.steps(), 0);
    }
}

TEST_F(Typing, aCopyIsMadeOfWhatWasTyped) {
    driver.key(Key::d, withControl);
    ASSERT_EQ(driver.session.document().curves.size(), 2U);
    EXPECT_EQ(x(0), 2) << "typed for this one";
    EXPECT_NE(x(1), before);
    EXPECT_EQ(driver.steps(), 2);
    driver.key(Key::enter);
    EXPECT_EQ(driver.steps(), 2) << "the field was left";
}

TEST_F(Typing, aSaveSavesWhatIsOnTheScreen) {
    driver.key(Key::s, withControl);
    EXPECT_EQ(x(0), 2);
    ASSERT_TRUE(lastRequest<SaveFile>(driver));
    driver.session.wasSaved("/there/known.json");
    EXPECT_FALSE(driver.session.unsaved());
}

TEST_F(Typing, whatIsNoNumberIsRefusedInTheWordsOfTheTable) {
    driver.type(" apples");
    driver.key(Key::enter);
    EXPECT_EQ(x(0), before);
    EXPECT_EQ(driver.steps(), 0);
    ASSERT_TRUE(driver.session.notice);
    EXPECT_EQ(driver.session.notice->text,
              "Set x of P₃ is not possible: x of P₃ is not a finite number; right would be: a "
              "finite number");
}

TEST_F(Typing, aChordThatMeansNothingChangesNothing) {
    driver.key(Key::slash, {.control = true, .alt = true});
    EXPECT_EQ(x(0), before) << "not entered yet";
    driver.type("5");
    driver.key(Key::enter);
    EXPECT_EQ(x(0), 25);
}

TEST_F(Typing, escapeAfterwardsStillGivesUp) {
    driver.key(Key::escape);
    EXPECT_EQ(x(0), before);
    EXPECT_EQ(driver.steps(), 0);
}

TEST(Keys, chooseInAList) {
    Driver driver(documentOf({curveOf("cardinal")}));
    driver.click(inInspector("##family"));
    driver.key(Key::down);
    driver.key(Key::enter);
    EXPECT_NE(driver.curve().family, "cardinal");
    EXPECT_EQ(driver.steps(), 1);
}

TEST(Keys, chooseInAMenu) {
    Driver driver(plain());
    driver.press(driver.atPoint(3), Button::right);
    driver.release(Button::right);
    ASSERT_TRUE(driver.session.contextMenu);
    driver.key(Key::down); // from the first entry, which is chosen already
    driver.key(Key::up);
    driver.key(Key::enter);
    EXPECT_EQ(driver.session.history.undoLabel(), "Cut");
    EXPECT_FALSE(driver.session.contextMenu);
    EXPECT_FALSE(driver.session.view.exactEntry) << "Enter was the menu's alone";
}

/// A document with a change, and the question whether to save it.
class Asked : public testing::Test {
  protected:
    Asked() {
        driver.session.path = "/there/known.json";
        driver.drag(driver.atPoint(3), driver.at({2, 2}));
        driver.send(CloseAsked{});
    }

    Driver driver{plain()};
};

TEST_F(Asked, enterSaves) {
    driver.key(Key::enter);
    EXPECT_TRUE(lastRequest<SaveFile>(driver));
}

TEST_F(Asked, arrowsGoToTheOtherAnswers) {
    driver.key(Key::right);
    driver.key(Key::enter);
    EXPECT_TRUE(lastRequest<Quit>(driver));
    EXPECT_FALSE(driver.session.dialog);
}

TEST_F(Asked, theLastAnswerIsToStay) {
    driver.key(Key::right);
    driver.key(Key::right);
    driver.key(Key::enter);
    EXPECT_FALSE(driver.session.dialog);
    EXPECT_TRUE(driver.session.requests.empty());
    EXPECT_TRUE(driver.session.unsaved());
}

} // namespace
} // namespace splineloft::ui
