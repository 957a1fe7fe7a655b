// Shortcuts as text, and the person's own in place of those that commands have by themselves.
#include "driver.h"
#include "hand.h"

#include "ui/keymap.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace splineloft::ui {
namespace {

TEST(ShortcutText, isReadBackForEveryKey) {
    std::set<std::string> names;
    constexpr int mostCodes = 400; // more than there are keys
    for (int code = 1; code <= mostCodes; ++code) {
        for (int held = 0; held < 8; ++held) {
            const Shortcut shortcut{static_cast<Key>(code),
                                    {(held & 1) != 0, (held & 2) != 0, (held & 4) != 0}};
            const auto name = nameOf(shortcut);
            EXPECT_TRUE(names.insert(name).second) << name << " means two shortcuts";
            const auto read = shortcutFrom(name);
            ASSERT_TRUE(read) << name;
            EXPECT_EQ(*read, shortcut) << name;
        }
    }
}

TEST(ShortcutText, isWrittenAsPeopleDo) {
    EXPECT_EQ(nameOf({Key::s, {.shift = true, .control = true}}), "Ctrl+Shift+S");
    EXPECT_EQ(nameOf({Key::equal, {.shift = true, .control = true}}), "Ctrl++");
    EXPECT_EQ(nameOf({Key::equal}), "=");
    EXPECT_EQ(nameOf({static_cast<Key>(290 + 4), {.alt = true}}), "Alt+F5");
    EXPECT_EQ(shortcutFrom("shift+CTRL+s"), (Shortcut{Key::s, {.shift = true, .control = true}}));
    EXPECT_EQ(shortcutFrom("Ctrl+Left"), (Shortcut{Key::left, {.control = true}}));
    EXPECT_EQ(shortcutFrom("page down"), (Shortcut{Key::pageDown}));
    EXPECT_EQ(shortcutFrom("f11"), (Shortcut{Key::f11}));
    EXPECT_EQ(shortcutFrom("f"), (Shortcut{Key::f}));
}

TEST(ShortcutText, nonsenseIsNone) {
    for (const char* text : {"", "Ctrl", "Ctrl+", "Ctrl+Shift", "Hyper+S", "SS", "F0", "F26", "F1x",
                             "Keypad 10", "key", "key -1", "Ctrl+ S", " ", "é"}) {
        EXPECT_FALSE(shortcutFrom(text)) << text;
    }
}

std::vector<Shortcut> shortcutsOf(const Session& session, const char* id) {
    const auto all = ui::shortcutsOf(session, commandNamed(id));
    return {all.begin(), all.end()};
}

TEST(Keymap, replacesWhatItNames) {
    Driver driver(documentOf({curveOf("cardinal")}));
    const auto found = keymapFrom(R"({"view.comb": ["F5", "Ctrl+U"], "view.joints": []})");
    EXPECT_TRUE(found.problems.empty()) << found.problems.front();
    driver.session.keymap = found.keymap;
    const bool before = driver.session.view.layers.comb;
    driver.key(Key::k);
    EXPECT_EQ(driver.session.view.layers.comb, before) << "its own shortcut is gone";
    driver.key(static_cast<Key>(294));
    EXPECT_NE(driver.session.view.layers.comb, before);
    driver.key(Key::u, withControl);
    EXPECT_EQ(driver.session.view.layers.comb, before);
    driver.key(Key::j);
    EXPECT_FALSE(driver.session.view.layers.joints) << "it has no shortcut any more";
    EXPECT_EQ(shortcutName(driver.session, commandNamed("view.comb")), "F5");
    EXPECT_EQ(shortcutName(driver.session, commandNamed("view.joints")), "");
    driver.key(Key::l);
    EXPECT_FALSE(driver.session.view.layers.ladder) << "what is not named stays";
}

TEST(Keymap, namesWhatMakesNoSenseAndTakesTheRest) {
    Session session;
    const auto [keymap, problems] = keymapFrom(R"({
        "file.fly": ["F5"], "file.open": "F6", "file.new": [7, "Hyper+N", "F7"],
        "view.comb": ["F8"]})");
    session.keymap = keymap;
    ASSERT_EQ(problems.size(), 4U);
    EXPECT_NE(problems[0].find("file.fly"), std::string::npos) << problems[0];
    EXPECT_NE(problems[1].find("file.open"), std::string::npos) << problems[1];
    EXPECT_NE(problems[2].find("file.new"), std::string::npos) << problems[2];
    EXPECT_NE(problems[3].find("Hyper+N"), std::string::npos) << problems[3];
    EXPECT_EQ(shortcutsOf(session, "file.new"), (std::vector<Shortcut>{{static_cast<Key>(296)}}));
    EXPECT_EQ(shortcutsOf(session, "view.comb"), (std::vector<Shortcut>{{static_cast<Key>(297)}}));
    EXPECT_EQ(shortcutsOf(session, "file.open"), commandNamed("file.open").shortcuts);
}

TEST(Keymap, oneShortcutHasOneCommand) {
    Session session;
    const auto [keymap, problems] =
        keymapFrom(R"({"view.comb": ["Ctrl+S", "F5"], "view.joints": ["F5", "F6"]})");
    session.keymap = keymap;
    ASSERT_EQ(problems.size(), 2U) << "F5 twice in the file, and Ctrl+S that was Save's";
    EXPECT_EQ(shortcutsOf(session, "view.comb").size(), 2U);
    EXPECT_EQ(shortcutName(session, commandNamed("view.joints")), "F6");
    EXPECT_TRUE(shortcutsOf(session, "file.save").empty());
}

TEST(Keymap, textThatIsNoKeymapChangesNothing) {
    for (const char* text : {"", "{", "[]", "3", R"({"view.comb": ["F5"],})"}) {
        const auto found = keymapFrom(text);
        EXPECT_TRUE(found.keymap.empty()) << text;
        EXPECT_EQ(found.problems.size(), 1U) << text;
    }
}

TEST(Keymap, writtenAndReadAgainIsTheSame) {
    Session session;
    session.keymap = keymapFrom(R"({"view.comb": ["F5"], "view.joints": ["Ctrl++"]})").keymap;
    const auto again = keymapFrom(keymapText(session));
    EXPECT_TRUE(again.problems.empty()) << again.problems.front();
    Session other;
    other.keymap = again.keymap;
    for (const auto& command : commands()) {
        EXPECT_EQ(shortcutsOf(other, command.id.c_str()), shortcutsOf(session, command.id.c_str()))
            << command.id;
    }
}

} // namespace
} // namespace splineloft::ui
