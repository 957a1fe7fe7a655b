// The table of commands: every entry runs, no two share a key, and keys mean nothing to the canvas
// while one types.
#include "driver.h"
#include "hand.h"

#include "core/spline/catalog.h"
#include "ui/commands.h"
#include "ui/panels/menus.h"

#include <gtest/gtest.h>

#include <list>
#include <set>
#include <utility>

namespace splineloft::ui {
namespace {

/// Sessions in all the states in which keys may mean something.
std::list<Session> situations() {
    std::list<Session> all;
    for (const auto& document : {Document{}, documentOf({curveOf("bezier-spline")}),
                                 documentOf({curveOf("hermite", true)}),
                                 documentOf({curveOf("linear"), curveOf("natural")})}) {
        for (const auto& selection : {Selection{}, Selection{{0, 0}}, Selection{{0, 0}, {0, 6}}}) {
            for (const auto tool : {Tool::select, Tool::pen}) {
                for (const bool playing : {false, true}) {
                    Session session(document);
                    session.view.selection = document.curves.empty() ? Selection{} : selection;
                    session.view.tool = tool;
                    session.view.playing = playing;
                    all.push_back(std::move(session));
                }
            }
        }
    }
    return all;
}

TEST(Commands, noTwoAnswerToAShortcutAtOnce) {
    for (const auto& session : situations()) {
        std::vector<std::pair<Shortcut, std::string>> owners;
        for (const auto& command : commands()) {
            for (const auto& shortcut : command.shortcuts) {
                for (const auto& [taken, owner] : owners) {
                    EXPECT_FALSE(taken == shortcut && command.possible(session))
                        << nameOf(shortcut) << ": " << owner << ", " << command.id;
                }
                if (command.possible(session)) {
                    owners.emplace_back(shortcut, command.id);
                }
            }
        }
    }
}

TEST(Commands, allAreWholeAndTheirIdsDiffer) {
    // The menus, the key list and the context menu are drawn by these titles.
    std::set<std::string> menus(menuTitles.begin(), menuTitles.end());
    menus.insert(""); // keys alone
    std::set<std::string> ids;
    const Session empty;
    for (const auto& command : commands()) {
        EXPECT_TRUE(ids.insert(command.id).second) << command.id;
        EXPECT_TRUE(menus.contains(command.menu)) << command.id << " stands in no known menu";
        EXPECT_TRUE(command.run) << command.id;
        EXPECT_FALSE(command.name(empty).empty()) << command.id;
        EXPECT_FALSE(command.menu.empty() && command.shortcuts.empty())
            << command.id << " cannot be reached";
    }
}

TEST(Commands, everyEntryRunsWhateverTheDocument) {
    Curve lone = curveOf("cardinal");
    lone.points = {{1, 2}};
    for (const auto& document : {Document{}, documentOf({lone}), documentOf({curveOf("hermite")}),
                                 documentOf({curveOf("linear", 1), curveOf("natural", 3)})}) {
        Driver driver(document);
        for (const auto& command : commands()) {
            driver.session.opened(document, "");
            driver.frames(1);
            if (driver.session.active() != nullptr) {
                driver.session.view.selection = {{0, 0}};
            }
            if (command.possible(driver.session)) {
                command.run(driver.session);
            }
            driver.session.dialog.reset();
            driver.frames(2);
            EXPECT_EQ(driver.faults(), "") << command.id;
        }
    }
}

TEST(Commands, everyShortcutDoesWhatItsCommandSays) {
    for (const auto& command : commands()) {
        for (const auto& shortcut : command.shortcuts) {
            Hand byKey(documentOf({curveOf("hermite")}));
            byKey.session.view.selection = {{0, 2}};
            Hand byName(byKey.session.document());
            byName.session.view.selection = {{0, 2}};
            if (!command.possible(byName.session)) {
                continue; // its key may mean something else here
            }
            byKey.key(shortcut.key, shortcut.modifiers);
            command.run(byName.session);
            EXPECT_EQ(byKey.session.document(), byName.session.document()) << command.id;
            EXPECT_EQ(byKey.session.view.layers, byName.session.view.layers) << command.id;
            EXPECT_EQ(byKey.session.view.camera, byName.session.view.camera) << command.id;
            EXPECT_EQ(byKey.session.view.selection, byName.session.view.selection) << command.id;
            EXPECT_EQ(byKey.session.view.tool, byName.session.view.tool) << command.id;
            EXPECT_EQ(byKey.session.view.theme, byName.session.view.theme) << command.id;
            EXPECT_EQ(byKey.session.view.playing, byName.session.view.playing) << command.id;
            EXPECT_EQ(byKey.session.view.cursor, byName.session.view.cursor) << command.id;
            EXPECT_EQ(byKey.session.view.interfaceScale, byName.session.view.interfaceScale)
                << command.id;
            EXPECT_EQ(byKey.session.view.presenting, byName.session.view.presenting) << command.id;
            EXPECT_EQ(byKey.session.view.log, byName.session.view.log) << command.id;
            EXPECT_EQ(byKey.session.view.activeCurve, byName.session.view.activeCurve)
                << command.id;
            EXPECT_EQ(byKey.session.history.undoLabel(), byName.session.history.undoLabel());
            EXPECT_EQ(byKey.session.requests.size(), byName.session.requests.size()) << command.id;
            ASSERT_EQ(byKey.session.dialog.has_value(), byName.session.dialog.has_value());
            if (byKey.session.dialog) {
                EXPECT_EQ(byKey.session.dialog->index(), byName.session.dialog->index())
                    << command.id;
            }
        }
    }
}

TEST(Shortcuts, theLayersGoOnAndOff) {
    Driver driver(documentOf({curveOf("cardinal")}));
    const std::vector<std::pair<Key, bool Layers::*>> keys = {
        {Key::g, &Layers::polygon}, {Key::n, &Layers::labels}, {Key::l, &Layers::ladder},
        {Key::k, &Layers::comb},    {Key::b, &Layers::beads},  {Key::j, &Layers::joints},
        {Key::r, &Layers::frames},  {Key::h, &Layers::basis}};
    EXPECT_EQ(keys.size(), namedLayers.size());
    for (const auto& [key, layer] : keys) {
        const bool before = driver.session.view.layers.*layer;
        driver.key(key);
        EXPECT_NE(driver.session.view.layers.*layer, before) << static_cast<char>(key);
        driver.key(key);
        EXPECT_EQ(driver.session.view.layers.*layer, before) << static_cast<char>(key);
    }
    EXPECT_EQ(driver.steps(), 0) << "how one looks is no edit";
}

TEST(Shortcuts, digitsSwitchTheFamily) {
    Driver driver(documentOf({curveOf("cardinal")}));
    for (int digit = 1; digit <= 9; ++digit) {
        driver.key(static_cast<Key>('0' + digit));
        EXPECT_EQ(driver.curve().family, catalog()[static_cast<std::size_t>(digit - 1)].id);
    }
}

TEST(Shortcuts, typingIsNoShortcut) {
    Driver driver(documentOf({curveOf("cardinal")}));
    const View before = driver.session.view;
    driver.click(pointField(1, 0));
    driver.type("f5p1e");
    driver.key(Key::home);
    driver.key(Key::del);
    driver.key(Key::backspace);
    driver.key(Key::left);
    driver.key(Key::space);
    EXPECT_EQ(driver.curve().family, "cardinal");
    EXPECT_EQ(driver.curve().points.size(), 7U);
    EXPECT_EQ(driver.session.view.camera, before.camera);
    EXPECT_EQ(driver.session.view.tool, Tool::select);
    EXPECT_EQ(driver.session.view.pace, before.pace);
    EXPECT_FALSE(driver.session.view.playing);
    EXPECT_EQ(driver.steps(), 0);
    driver.key(Key::escape);
    driver.key(Key::p);
    EXPECT_EQ(driver.session.view.tool, Tool::pen) << "after the field, keys are keys again";
}

TEST(Shortcuts, undoInAFieldUndoesOnlyWhatWasTyped) {
    Driver driver(documentOf({curveOf("cardinal")}));
    driver.enter(pointField(1, 0), "-1.5");
    ASSERT_EQ(driver.steps(), 1);
    driver.click(pointField(2, 0));
    driver.type("88");
    for (int i = 0; i < 4; ++i) {
        driver.key(Key::z, withControl);
    }
    driver.key(Key::enter);
    EXPECT_EQ(driver.curve().points.at(1)[0], -1.5) << "the document's step is still there";
    driver.key(Key::z, withControl);
    EXPECT_EQ(driver.curve().points, sevenPoints());
}

TEST(Shortcuts, mayBeUsedWithTheFocusInNoField) {
    Driver driver(documentOf({curveOf("cardinal")}));
    driver.enter(pointField(1, 0), "-1.5");
    driver.key(Key::z, withControl);
    EXPECT_EQ(driver.curve().points, sevenPoints());
    driver.key(Key::z, {.shift = true, .control = true});
    EXPECT_EQ(driver.curve().points.at(1)[0], -1.5);
}

TEST(Shortcuts, doNothingBehindADialog) {
    Driver driver(documentOf({curveOf("cardinal")}));
    driver.key(Key::f1);
    ASSERT_TRUE(driver.session.dialog);
    driver.key(static_cast<Key>(49));
    driver.key(Key::c);
    driver.click(driver.atPoint(2));
    EXPECT_EQ(driver.steps(), 0);
    EXPECT_TRUE(driver.session.view.selection.empty());
    driver.key(Key::escape);
    EXPECT_FALSE(driver.session.dialog);
    driver.click(driver.atPoint(2));
    EXPECT_EQ(driver.session.view.selection.size(), 1U) << "the canvas is there again";
}

TEST(Shortcuts, aKeyHeldDownSwitchesOnce) {
    Driver driver(documentOf({curveOf("cardinal")}));
    const bool before = driver.session.view.layers.comb;
    driver.send(KeyChanged{Key::k, true, false, {}});
    driver.send(KeyChanged{Key::k, true, true, {}});
    driver.send(KeyChanged{Key::k, false, false, {}});
    EXPECT_NE(driver.session.view.layers.comb, before);
}

TEST(Shortcuts, anArrowHeldDownNudgesOnAndOn) {
    Driver driver(documentOf({curveOf("cardinal")}));
    driver.session.view.selection = {{0, 3}};
    driver.send(KeyChanged{Key::up, true, false, {}});
    const double once = driver.curve().points.at(3)[1] - 1.125;
    driver.send(KeyChanged{Key::up, true, true, {}});
    driver.send(KeyChanged{Key::up, true, true, {}});
    EXPECT_NEAR(driver.curve().points.at(3)[1] - 1.125, 3 * once, 1e-9);
}

TEST(Menus, undoSaysWhatItWouldUndo) {
    Driver driver(documentOf({curveOf("cardinal")}));
    driver.drag(driver.atPoint(3), driver.at({2, 2}));
    EXPECT_EQ(commandNamed("edit.undo").name(driver.session), "Undo Move P₃");
    driver.takeFromMenu(1, 0);
    EXPECT_EQ(driver.curve().points, sevenPoints());
    EXPECT_EQ(commandNamed("edit.redo").name(driver.session), "Redo Move P₃");
    driver.takeFromMenu(1, 1);
    EXPECT_EQ(driver.steps(), 1);
}

TEST(Menus, theEntriesOfTheMenuViewSwitchLayers) {
    Driver driver(documentOf({curveOf("cardinal")}));
    const Layers before = driver.session.view.layers;
    driver.takeFromMenu(2, 3);
    EXPECT_NE(driver.session.view.layers.polygon, before.polygon);
}

TEST(ToolRail, itsButtonsAreCommands) {
    Driver driver(documentOf({curveOf("cardinal")}));
    driver.click(Widget{"tools", {"✎"}});
    EXPECT_EQ(driver.session.view.tool, Tool::pen);
    driver.click(Widget{"tools", {"↖"}});
    EXPECT_EQ(driver.session.view.tool, Tool::select);
    const bool comb = driver.session.view.layers.comb;
    driver.click(Widget{"tools", {"≋"}});
    EXPECT_NE(driver.session.view.layers.comb, comb);
}

} // namespace
} // namespace splineloft::ui
