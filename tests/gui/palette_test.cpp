// The palette of commands: letters find a name, and what is taken runs.
#include "driver.h"
#include "hand.h"

#include "ui/command_search.h"
#include "ui/fuzzy.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace splineloft::ui {
namespace {

constexpr Modifiers controlShift{.shift = true, .control = true};

double score(std::string_view pattern, std::string_view text) {
    const auto match = fuzzyMatch(pattern, text);
    return match ? match->score : -1e9;
}

std::string matched(std::string_view pattern, const std::string& text) {
    const auto match = fuzzyMatch(pattern, text);
    std::string letters;
    for (const auto at : match ? match->letters : std::vector<std::size_t>()) {
        letters += text[at];
    }
    return letters;
}

TEST(Fuzzy, aWordMatchesWhereItsLettersFollowInOrder) {
    EXPECT_TRUE(fuzzyMatch("zmin", "View: Zoom in"));
    EXPECT_TRUE(fuzzyMatch("ZOOM", "View: Zoom in"));
    EXPECT_FALSE(fuzzyMatch("inz", "View: Zoom in"));
    EXPECT_FALSE(fuzzyMatch("zz", "View: Zoom in")) << "there is one z";
    EXPECT_FALSE(fuzzyMatch("a", ""));
    EXPECT_TRUE(fuzzyMatch("", ""));
    EXPECT_EQ(score("", "View: Zoom in"), 0);
    EXPECT_EQ(score("   ", "View: Zoom in"), 0);
}

TEST(Fuzzy, wordsMatchInAnyOrder) {
    EXPECT_TRUE(fuzzyMatch("in zoom", "View: Zoom in"));
    EXPECT_FALSE(fuzzyMatch("in doom", "View: Zoom in"));
}

TEST(Fuzzy, accentsMayBeLeftOut) {
    const std::string text = "Family: Bézier spline";
    EXPECT_TRUE(fuzzyMatch("bezier", text));
    EXPECT_TRUE(fuzzyMatch("BÉZIER", text));
    const auto match = fuzzyMatch("bezi", text);
    ASSERT_TRUE(match);
    EXPECT_EQ(match->letters, (std::vector<std::size_t>{8, 9, 11, 12})) << "é has two bytes";
}

TEST(Fuzzy, beginningsOfWordsAndLettersInARowCountMore) {
    EXPECT_GT(score("lt", "View: Light theme"), score("lt", "Edit: Select all the points"));
    EXPECT_GT(score("comb", "View: Curvature comb"), score("comb", "Close one more bend"));
    EXPECT_GT(score("save", "File: Save"), score("save", "File: Save as…") - 1e-9);
    EXPECT_EQ(matched("cc", "View: Curvature comb"), "Cc");
    // The c of comb, though there are others before it.
    EXPECT_EQ(fuzzyMatch("comb", "View: Curvature comb")->letters,
              (std::vector<std::size_t>{16, 17, 18, 19}));
}

TEST(Fuzzy, findsTheBestOfAllWaysAndNotTheFirst) {
    EXPECT_EQ(fuzzyMatch("fi", "if Fit")->letters, (std::vector<std::size_t>{3, 4}));
}

std::vector<std::string> titles(const Session& session, std::string_view typed) {
    std::vector<std::string> all;
    for (const auto& found : findCommands(session, typed)) {
        all.push_back(found.title);
    }
    return all;
}

TEST(CommandSearch, offersEveryCommandAtFirst) {
    const Session session;
    EXPECT_EQ(titles(session, "").size(), commands().size());
    EXPECT_EQ(titles(session, "").front(), "File: New") << "in the order of the menus";
}

TEST(CommandSearch, theNameThatIsMeantComesFirst) {
    const Session session(documentOf({curveOf("cardinal")}));
    EXPECT_EQ(titles(session, "light").front(), "View: Light theme");
    EXPECT_EQ(titles(session, "save").front(), "File: Save");
    EXPECT_EQ(titles(session, "bspl").front(), "Family: B-spline");
    EXPECT_EQ(titles(session, "fam dist").size(), titles(session, "dist fam").size());
    EXPECT_TRUE(titles(session, "qqqq").empty());
}

TEST(CommandSearch, whatWasRunHereBeforeComesFirst) {
    Session session;
    session.recentCommands = {"view.comb", "file.new"};
    EXPECT_EQ(titles(session, "")[0], "View: Curvature comb");
    EXPECT_EQ(titles(session, "")[1], "File: New");
    EXPECT_EQ(titles(session, "").size(), commands().size()) << "and nothing twice";
    EXPECT_EQ(titles(session, "light").front(), "View: Light theme") << "but not before a match";
}

class PaletteTest : public testing::Test {
  protected:
    void open() {
        driver.key(Key::p, controlShift);
        ASSERT_TRUE(isOpen());
        driver.frames(2);
    }
    bool isOpen() const {
        return driver.session.dialog && std::holds_alternative<Palette>(*driver.session.dialog);
    }

    Driver driver{documentOf({curveOf("cardinal")})};
};

TEST_F(PaletteTest, runsWhatIsTyped) {
    open();
    driver.type("light");
    driver.key(Key::enter);
    EXPECT_EQ(driver.session.view.theme, ThemeKind::light);
    EXPECT_FALSE(driver.session.dialog);
    EXPECT_EQ(driver.session.recentCommands, (std::vector<std::string>{"view.light"}));
    open();
    driver.key(Key::enter);
    EXPECT_EQ(driver.session.view.theme, ThemeKind::dark) << "the latest stands at the top";
    EXPECT_EQ(driver.session.recentCommands.size(), 1U);
}

TEST_F(PaletteTest, arrowsChooseAnotherRow) {
    open();
    driver.type("save");
    driver.key(Key::down);
    driver.key(Key::enter);
    ASSERT_TRUE(driver.session.dialog) << "the second is Save as…";
    EXPECT_TRUE(std::holds_alternative<FileBrowser>(*driver.session.dialog));
    driver.frames(3);
    EXPECT_TRUE(driver.has(inDialog("Cancel"))) << "and it is drawn";
}

TEST_F(PaletteTest, upFromTheFirstRowIsTheLast) {
    open();
    driver.type("zoom");
    driver.key(Key::up);
    const auto found = findCommands(driver.session, "zoom");
    EXPECT_EQ(std::get<Palette>(*driver.session.dialog).chosen, found.size() - 1);
    driver.key(Key::down);
    EXPECT_EQ(std::get<Palette>(*driver.session.dialog).chosen, 0U);
}

TEST_F(PaletteTest, whatIsImpossibleIsNotRun) {
    open();
    driver.type("redo");
    ASSERT_FALSE(commandNamed("edit.redo").possible(driver.session));
    driver.key(Key::enter);
    EXPECT_TRUE(isOpen());
    EXPECT_TRUE(driver.session.recentCommands.empty());
    driver.type("x");
    driver.key(Key::backspace);
    driver.key(Key::escape);
    EXPECT_FALSE(driver.session.dialog);
}

TEST_F(PaletteTest, aClickRunsToo) {
    open();
    driver.type("lighttheme");
    driver.frames(2);
    driver.click(Widget{"/found_", {"##view.light"}});
    EXPECT_EQ(driver.session.view.theme, ThemeKind::light);
    EXPECT_FALSE(driver.session.dialog);
}

TEST_F(PaletteTest, escapeClosesItAndChangesNothing) {
    open();
    driver.type("light");
    driver.key(Key::escape);
    EXPECT_FALSE(driver.session.dialog);
    EXPECT_EQ(driver.session.view.theme, ThemeKind::dark);
    driver.key(Key::t);
    EXPECT_EQ(driver.session.view.theme, ThemeKind::light) << "keys are shortcuts again";
}

TEST_F(PaletteTest, everyCommandCanBeTakenFromIt) {
    for (const auto& command : commands()) {
        driver.session.opened(documentOf({curveOf("parametric-parabola")}), "");
        driver.session.view.selection = {{0, 0}};
        if (command.id == "help.palette" || !command.possible(driver.session)) {
            continue;
        }
        const auto found = findCommands(driver.session, command.name(driver.session));
        const auto here = std::ranges::find(found, &command, &FoundCommand::command);
        EXPECT_LT(here - found.begin(), 4) << command.id << " is not found by its name";
        driver.session.dialog = Palette{};
        driver.frames(2);
        const auto all = findCommands(driver.session, "");
        std::get<Palette>(*driver.session.dialog).chosen = static_cast<std::size_t>(
            std::ranges::find(all, &command, &FoundCommand::command) - all.begin());
        driver.key(Key::enter);
        EXPECT_EQ(driver.session.recentCommands.front(), command.id);
        driver.session.dialog.reset();
        driver.session.present(false);
        driver.session.view.interfaceScale = 1;
        driver.frames(2);
        EXPECT_EQ(driver.faults(), "") << command.id;
    }
}

} // namespace
} // namespace splineloft::ui
