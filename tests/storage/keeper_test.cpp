// What else the keeper does: its folders, files opened together, the file of shortcuts.
#include "sitting.h"

#include "tests/unit/child_process.h"
#include "ui/commands.h"

namespace splineloft::app {
namespace {

TEST(Keeper, withoutAnyFolderSaysSoOnceAndGoesOn) {
    Keeper keeper({});
    ui::Session session(documentWith(0), "");
    keeper.begin(session, {});
    EXPECT_EQ(session.log.messages().size(), 1U) << session.log.text();
    EXPECT_CONTAINS(noticeOf(session), "HOME");
    change(session, 1);
    session.view.beads = 3;
    for (const ui::Request& request :
         {ui::Request(ui::LookForRecent{}), ui::Request(ui::ForgetRecent{}),
          ui::Request(ui::ReadShortcuts{}), ui::Request(ui::MakeShortcutsFile{})}) {
        session.requests.push_back(request);
    }
    EXPECT_TRUE(keeper.afterFrame(session, {}));
    EXPECT_TRUE(keeper.attend(session)) << "a frame has yet to show what was said";
    EXPECT_EQ(keeper.patience(), never);
}

TEST(Places, comeFromTheEnvironment) {
    const auto with = [](const char* config, const char* state, const char* home) {
        const auto ending =
            inChild([] { return true; },
                    [=] {
                        const auto set = [](const char* name, const char* value) {
                            value != nullptr ? ::setenv(name, value, 1) : ::unsetenv(name);
                        };
                        set("XDG_CONFIG_HOME", config);
                        set("XDG_STATE_HOME", state);
                        set("HOME", home);
                        const auto places = placesFromEnvironment();
                        return places.config.string() + " " + places.state.string();
                    });
        return ending.said;
    };
    EXPECT_EQ(with("/c", "/s", "/h"), "/c/splineloft /s/splineloft");
    EXPECT_EQ(with(nullptr, "", "/h"), "/h/.config/splineloft /h/.local/state/splineloft");
    EXPECT_EQ(with("relative", nullptr, "/h"), "/h/.config/splineloft /h/.local/state/splineloft");
    EXPECT_EQ(with(nullptr, nullptr, nullptr), " ");
}

TEST(OpenTogether, namesTheFilesThatCannotBeReadAndOpensTheOthers) {
    const TemporaryFolder folder;
    put(folder / "broken.json", "{");
    put(folder / "a.json", writeDocument(documentWith(1)));
    put(folder / "b.json", writeDocument(documentWith(2)));
    Sitting sitting(folder.path());
    sitting.request(
        ui::OpenFiles{{(folder / "broken.json").string(), (folder / "a.json").string(),
                       (folder / "missing.json").string(), (folder / "b.json").string()}});
    EXPECT_EQ(sitting.session.document().curves.size(), 2U);
    EXPECT_EQ(sitting.session.path, (folder / "a.json").string());
    EXPECT_TRUE(sitting.session.unsaved()) << "the second curve is in no file of that name";
    EXPECT_TRUE(sitting.session.notice->isProblem);
    EXPECT_CONTAINS(noticeOf(sitting.session), "broken.json");
    EXPECT_CONTAINS(noticeOf(sitting.session), "missing.json");
    EXPECT_EQ(namesOf(sitting.session.recent), (std::vector<std::string>{"a.json", "b.json"}));
}

TEST(OpenTogether, whereNoneCanBeReadTheDocumentStays) {
    const TemporaryFolder folder;
    Sitting sitting(folder.path());
    change(sitting.session, 3);
    sitting.request(ui::OpenFiles{{(folder / "x").string(), (folder / "y").string()}});
    EXPECT_EQ(sitting.session.document(), documentWith(3));
    EXPECT_TRUE(sitting.session.unsaved());
}

TEST(ShortcutsFile, isMadeWithAllShortcutsAndReadAgain) {
    const TemporaryFolder folder;
    const auto file = folder / "config/shortcuts.json";
    Sitting sitting(folder.path());
    sitting.request(ui::MakeShortcutsFile{});
    EXPECT_CONTAINS(noticeOf(sitting.session), file.string());
    EXPECT_CONTAINS(contents(file), "\"file.saveAs\": [\"Ctrl+Shift+S\"]");
    put(file, R"({"file.saveAs": ["F5"], "file.fly": []})");
    sitting.request(ui::MakeShortcutsFile{});
    EXPECT_EQ(contents(file), R"({"file.saveAs": ["F5"], "file.fly": []})") << "it stays";
    sitting.request(ui::ReadShortcuts{});
    EXPECT_EQ(ui::shortcutName(sitting.session, ui::commandNamed("file.saveAs")), "F5");
    EXPECT_CONTAINS(noticeOf(sitting.session), "file.fly");
    fs::remove(file);
    sitting.request(ui::ReadShortcuts{});
    EXPECT_EQ(ui::shortcutName(sitting.session, ui::commandNamed("file.saveAs")), "Ctrl+Shift+S");
}

} // namespace
} // namespace splineloft::app
