// A whole sitting as the disk sees it: settings, recent files, shortcuts, saving and failing to
// save, and the offer of unsaved work at the next start.
#include "app/files.h"
#include "app/storage/keeper.h"
#include "app/storage/recent_files.h"
#include "temporary_folder.h"
#include "tests/unit/child_process.h"
#include "ui/commands.h"

#include <gtest/gtest.h>

#include <sys/stat.h>

namespace splineloft::app {
namespace {

/// A sitting whose places are below a folder.
class Sitting {
  public:
    explicit Sitting(const fs::path& folder, const std::vector<std::string>& files = {},
                     AutosavePace pace = {})
        : keeper({folder / "config", folder / "state"}, pace) {
        if (!files.empty()) {
            openTogether(session, files);
        }
        keeper.begin(session, files);
    }

    /// What the loop does after a frame; false where the program ends.
    bool frame() { return keeper.afterFrame(session, screen); }
    /// Lets frames pass until nothing is under way, or for so many seconds.
    void settle(double most = 3) {
        const auto end = after(Clock::now(), most);
        frame();
        while (Clock::now() < end && keeper.patience() < 1.5) {
            ::usleep(2000);
            keeper.attend(session);
        }
    }
    bool quit() {
        session.requests.emplace_back(ui::Quit{});
        return !frame();
    }
    void request(ui::Request request) {
        session.requests.push_back(std::move(request));
        frame();
    }

    Keeper keeper;
    ui::Session session;
    ui::Screen screen;
};

std::string noticeOf(const ui::Session& session) {
    return session.notice ? session.notice->text : "";
}

#define EXPECT_CONTAINS(text, part)                                                                \
    EXPECT_NE(std::string(text).find(part), std::string::npos) << "in: " << (text)

// --- settings
// -------------------------------------------------------------------------------------

TEST(SettingsFile, isWrittenAfterASecondOfCalmAndReadAtTheNextStart) {
    const TemporaryFolder folder;
    const auto file = folder / "config/settings.json";
    {
        Sitting sitting(folder.path());
        sitting.settle();
        EXPECT_FALSE(fs::exists(file)) << "nothing was changed";
        sitting.session.view.theme = ui::ThemeKind::light;
        sitting.frame();
        EXPECT_GT(sitting.keeper.patience(), 0.5);
        EXPECT_LT(sitting.keeper.patience(), 1.01);
        EXPECT_FALSE(fs::exists(file)) << "not at once";
        sitting.settle();
        EXPECT_TRUE(fs::exists(file));
        EXPECT_EQ(sitting.keeper.patience(), never);
    }
    const Sitting next(folder.path());
    EXPECT_EQ(next.session.view.theme, ui::ThemeKind::light);
}

TEST(SettingsFile, isWrittenAtTheEndWithTheSizeOfTheWindow) {
    const TemporaryFolder folder;
    {
        Sitting sitting(folder.path());
        sitting.screen = {1800, 1200, 2};
        EXPECT_TRUE(sitting.quit());
    }
    const Sitting next(folder.path());
    EXPECT_EQ(next.session.habits.windowWidth, 900);
    EXPECT_EQ(next.session.habits.windowHeight, 600);
}

TEST(SettingsFile, thatIsBrokenIsPutAsideAndTold) {
    const TemporaryFolder folder;
    const auto file = folder / "config/settings.json";
    put(file, "{\"theme\": \"lig");
    {
        Sitting sitting(folder.path());
        EXPECT_CONTAINS(noticeOf(sitting.session), file.string() + ": 1:");
        EXPECT_EQ(sitting.session.view.theme, ui::ThemeKind::dark);
        EXPECT_FALSE(fs::exists(file));
        EXPECT_EQ(contents(folder / "config/settings.json.bad"), "{\"theme\": \"lig");
        sitting.session.view.beads = 5;
        EXPECT_TRUE(sitting.quit());
    }
    const Sitting next(folder.path());
    EXPECT_FALSE(next.session.notice) << noticeOf(next.session);
    EXPECT_EQ(next.session.view.beads, 5);
    EXPECT_EQ(contents(folder / "config/settings.json.bad"), "{\"theme\": \"lig");
}

TEST(SettingsFile, aFolderThatCannotBeWrittenToIsSaidOnce) {
    const TemporaryFolder folder;
    fs::create_directories(folder / "config");
    fs::create_directories(folder / "state");
    ::chmod((folder / "config").c_str(), 0555);
    ::chmod((folder / "state").c_str(), 0777);
    const auto ending = inChild(becomeNobody, [&] {
        Sitting sitting(folder.path());
        for (int beads = 5; beads < 8; ++beads) {
            sitting.session.view.beads = beads;
            sitting.settle();
        }
        const bool ended = sitting.quit();
        return sitting.session.log.text() + (ended ? "ended" : "goes on");
    });
    ASSERT_TRUE(ending.couldStart);
    EXPECT_CONTAINS(ending.said, "permission denied");
    EXPECT_EQ(std::ranges::count(ending.said, '\n'), 1) << ending.said;
    EXPECT_TRUE(ending.said.ends_with("ended")) << ending.said;
}

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

// --- files of late
// --------------------------------------------------------------------------------

std::vector<std::string> namesOf(const std::vector<ui::RecentFile>& files) {
    std::vector<std::string> found;
    for (const auto& file : files) {
        found.push_back(fs::path(file.path).filename().string());
    }
    return found;
}

TEST(RecentFiles, theLatestComesFirstAndNoneTwice) {
    const TemporaryFolder folder;
    for (const char* name : {"a", "b", "c"}) {
        put(folder / name, writeDocument(documentWith(1)));
    }
    {
        Sitting sitting(folder.path());
        for (const char* name : {"a", "b", "a", "c", "b"}) {
            sitting.request(ui::OpenFiles{{(folder / name).string()}});
        }
        sitting.request(ui::SaveFile{(folder / "d").string()});
        EXPECT_TRUE(sitting.quit());
    }
    const Sitting next(folder.path());
    EXPECT_EQ(namesOf(next.session.recent), (std::vector<std::string>{"d", "b", "c", "a"}));
    EXPECT_TRUE(fs::path(next.session.recent[0].path).is_absolute());
}

TEST(RecentFiles, thatAreGoneAreStillListedButSaidToBe) {
    const TemporaryFolder folder;
    put(folder / "a", writeDocument(documentWith(1)));
    Sitting sitting(folder.path());
    sitting.request(ui::OpenFiles{{(folder / "a").string()}});
    sitting.settle();
    fs::remove(folder / "a");
    sitting.request(ui::LookForRecent{});
    ASSERT_EQ(sitting.session.recent.size(), 1U);
    EXPECT_FALSE(sitting.session.recent[0].isThere);
    sitting.request(ui::ForgetRecent{});
    sitting.settle();
    EXPECT_TRUE(readRecent(folder / "state/recent.json").empty());
}

TEST(RecentFiles, areTwelveAtMost) {
    const TemporaryFolder folder;
    for (int i = 0; i < 30; ++i) {
        ASSERT_TRUE(noteRecent(folder / "recent.json", "/there/" + std::to_string(i)));
    }
    const auto files = readRecent(folder / "recent.json");
    ASSERT_EQ(files.size(), 12U);
    EXPECT_EQ(files[0].path, "/there/29");
}

TEST(RecentFiles, ofEditorsThatRunAtOnceAreAllKept) {
    const TemporaryFolder folder;
    std::vector<pid_t> children;
    for (int editor = 0; editor < 4; ++editor) {
        const auto child = ::fork();
        if (child == 0) {
            for (int i = 0; i < 3; ++i) {
                [[maybe_unused]] const auto done =
                    noteRecent(folder / "recent.json",
                               "/there/" + std::to_string(editor) + "-" + std::to_string(i));
            }
            ::_exit(0);
        }
        children.push_back(child);
    }
    for (const auto child : children) {
        ::waitpid(child, nullptr, 0);
    }
    const auto files = namesOf(readRecent(folder / "recent.json"));
    EXPECT_EQ(std::set<std::string>(files.begin(), files.end()).size(), 12U);
}

TEST(RecentFiles, aDamagedListIsAnEmptyOne) {
    const TemporaryFolder folder;
    for (const char* text : {"", "{}", "[3, null]", "[\"a\""}) {
        put(folder / "recent.json", text);
        EXPECT_TRUE(readRecent(folder / "recent.json").empty()) << text;
    }
    EXPECT_TRUE(noteRecent(folder / "recent.json", "/there/a"));
    EXPECT_EQ(readRecent(folder / "recent.json").size(), 1U);
}

// --- several files at once
// --------------------------------------------------------------------------

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

// --- saving that fails
// ------------------------------------------------------------------------------

/// A save that must fail. `prepare` makes it so, in a process of its own; `why` is what must be
/// said. Document, file and mark must be as before.
struct Failure {
    const char* name;
    std::function<bool(const fs::path& folder)> prepare;
    const char* why;
    const char* file = "path.json";
};

void expectThatNothingIsLost(const Failure& failure) {
    SCOPED_TRACE(failure.name);
    const TemporaryFolder folder;
    ::chmod(folder.path().c_str(), 0777);
    const auto path = folder / failure.file;
    const auto ending = inChild(
        [&] {
            // What is to be there beforehand may have to lie on the file system that is mounted.
            return failure.prepare(folder.path());
        },
        [&] {
            ui::Session session(documentWith(1), path.string());
            change(session, 2);
            const auto before = contents(path);
            const auto around = names(folder.path());
            const bool saved = saveTo(session, path.string());
            std::string wrong = saved ? "saved! " : "";
            wrong += session.unsaved() ? "" : "not unsaved any more! ";
            wrong += session.document() == documentWith(2) ? "" : "another document! ";
            wrong += session.path == path.string() ? "" : "another path! ";
            wrong += contents(path) == before ? "" : "another text! ";
            wrong += names(folder.path()) == around ? "" : "litter! ";
            wrong += session.notice && session.notice->isProblem ? "" : "nothing said! ";
            return wrong + noticeOf(session);
        });
    if (!ending.couldStart) {
        std::cout << "SKIPPED: " << failure.name << ": not possible here\n";
        return;
    }
    EXPECT_TRUE(ending.said.starts_with(path.string())) << ending.said;
    EXPECT_CONTAINS(ending.said, failure.why);
}

/// Puts an old file there, then makes the save fail.
auto withFile(std::function<bool(const fs::path&)> then) {
    return [then](const fs::path& folder) {
        put(folder / "path.json", "old");
        ::chmod((folder / "path.json").c_str(), 0666);
        return then(folder);
    };
}

TEST(FailedSave, leavesFileDocumentAndMarkAsTheyWere) {
    const std::vector<Failure> failures = {
        {"a full disk",
         [](const fs::path& folder) {
             return mountSmall(folder) && withFile([](const fs::path& f) {
                        std::ofstream(f / "filler") << std::string(16'384, 'x');
                        return true;
                    })(folder);
         },
         "the disk is full"},
        {"a limit for files", withFile([](const fs::path&) { return limitFiles(50); }),
         "too large"},
        {"a read-only file system",
         [](const fs::path& folder) {
             return mountSmall(folder) && withFile([](const fs::path& f) {
                        return ::mount("none", f.c_str(), "tmpfs", MS_REMOUNT | MS_RDONLY,
                                       nullptr) == 0;
                    })(folder);
         },
         "read-only"},
        {"a write-protected file", withFile([](const fs::path& folder) {
             ::chmod((folder / "path.json").c_str(), 0444);
             return becomeNobody();
         }),
         "permission denied"},
        {"a write-protected folder", withFile([](const fs::path& folder) {
             ::chmod(folder.c_str(), 0555);
             return becomeNobody();
         }),
         "permission denied"},
        {"a folder that may not be entered", withFile([](const fs::path& folder) {
             ::chmod(folder.c_str(), 0600);
             return becomeNobody();
         }),
         "permission denied"},
        {"a folder that is gone", [](const fs::path& folder) { return fs::remove(folder); },
         "its folder does not exist"},
        {"a link whose target's folder is gone",
         [](const fs::path& folder) {
             fs::create_symlink("gone/target.json", folder / "path.json");
             return true;
         },
         "the folder that its link leads to does not exist"},
        {"a link in a circle",
         [](const fs::path& folder) {
             fs::create_symlink("path.json", folder / "path.json");
             return true;
         },
         "circle"},
        {"a folder in its place",
         [](const fs::path& folder) { return fs::create_directory(folder / "path.json"); },
         "is a folder"}};
    for (const auto& failure : failures) {
        expectThatNothingIsLost(failure);
    }
}

TEST(Save, throughALinkKeepsTheLinkAndReplacesItsTarget) {
    const TemporaryFolder folder;
    put(folder / "target.json", "old");
    fs::create_symlink("target.json", folder / "path.json");
    ui::Session session(documentWith(1), (folder / "path.json").string());
    change(session, 2);
    EXPECT_TRUE(saveTo(session, session.path));
    EXPECT_TRUE(fs::is_symlink(folder / "path.json"));
    EXPECT_EQ(contents(folder / "target.json"), writeDocument(documentWith(2)));
    EXPECT_FALSE(session.unsaved());
}

// --- unsaved work
// ---------------------------------------------------------------------------------

/// An editor that is killed with unsaved changes of a file.
void dieWithChanges(const TemporaryFolder& folder, const std::string& name, double x) {
    const auto child = ::fork();
    if (child == 0) {
        Sitting sitting(folder.path(), {(folder / name).string()}, {1, 20});
        sitting.session.dialog.reset();
        change(sitting.session, x);
        sitting.settle(1);
        ::kill(::getpid(), SIGKILL);
    }
    ::waitpid(child, nullptr, 0);
}

TEST(UnsavedWork, isOfferedAndRestoredAsChangesOfItsFile) {
    const TemporaryFolder folder;
    const auto saved = writeDocument(documentWith(1));
    put(folder / "path.json", saved);
    dieWithChanges(folder, "path.json", 2);
    Sitting sitting(folder.path());
    ASSERT_EQ(sitting.session.unsavedWork.size(), 1U);
    ASSERT_TRUE(sitting.session.dialog);
    EXPECT_TRUE(std::holds_alternative<ui::RecoveryOffer>(*sitting.session.dialog));
    sitting.request(ui::RestoreWork{sitting.session.unsavedWork[0].id});
    EXPECT_EQ(sitting.session.document(), documentWith(2));
    EXPECT_EQ(sitting.session.path, (folder / "path.json").string());
    EXPECT_TRUE(sitting.session.unsaved());
    EXPECT_TRUE(sitting.session.unsavedWork.empty());
    EXPECT_EQ(contents(folder / "path.json"), saved) << "the file waits for a save";
    sitting.session.undo();
    EXPECT_EQ(sitting.session.document(), documentWith(1)) << "back to what is in the file";
    sitting.session.redo();
    sitting.request(ui::SaveFile{sitting.session.path});
    EXPECT_EQ(contents(folder / "path.json"), writeDocument(documentWith(2)));
    EXPECT_TRUE(names(folder / "state/recovery").empty());
}

TEST(UnsavedWork, ofSeveralOneIsOpenedAndTheOthersStayOffered) {
    const TemporaryFolder folder;
    for (const char* name : {"a.json", "b.json", "c.json"}) {
        put(folder / name, writeDocument(documentWith(1)));
    }
    std::vector<pid_t> children;
    dieWithChanges(folder, "a.json", 2);
    dieWithChanges(folder, "b.json", 3);
    dieWithChanges(folder, "c.json", 4);
    {
        Sitting sitting(folder.path());
        ASSERT_EQ(sitting.session.unsavedWork.size(), 3U);
        const auto idOf = [&](const char* name) {
            for (const auto& work : sitting.session.unsavedWork) {
                if (work.path.ends_with(name)) {
                    return work.id;
                }
            }
            return std::string();
        };
        sitting.request(ui::RestoreWork{idOf("b.json")});
        EXPECT_EQ(sitting.session.document(), documentWith(3));
        EXPECT_EQ(sitting.session.unsavedWork.size(), 2U);
        EXPECT_TRUE(ui::commandNamed("file.unsavedWork").possible(sitting.session));
        sitting.request(ui::DiscardWork{idOf("a.json")});
        EXPECT_EQ(sitting.session.unsavedWork.size(), 1U);
        sitting.request(ui::RestoreWork{"no such id"});
        EXPECT_EQ(sitting.session.document(), documentWith(3));
        EXPECT_TRUE(sitting.quit()) << "without saving, deliberately";
    }
    const Sitting next(folder.path());
    ASSERT_EQ(next.session.unsavedWork.size(), 1U) << "the one that was left for later";
    EXPECT_TRUE(next.session.unsavedWork[0].path.ends_with("c.json"));
}

TEST(UnsavedWork, ofAFileThatIsGoneIsRestoredAllTheSame) {
    const TemporaryFolder folder;
    put(folder / "path.json", writeDocument(documentWith(1)));
    dieWithChanges(folder, "path.json", 2);
    fs::remove(folder / "path.json");
    Sitting sitting(folder.path());
    ASSERT_EQ(sitting.session.unsavedWork.size(), 1U);
    sitting.request(ui::RestoreWork{sitting.session.unsavedWork[0].id});
    EXPECT_EQ(sitting.session.document(), documentWith(2));
    EXPECT_TRUE(sitting.session.unsaved());
}

TEST(UnsavedWork, isLeftByNoneWhoEndsAsWished) {
    const TemporaryFolder folder;
    Sitting sitting(folder.path(), {}, {1, 20});
    change(sitting.session, 2);
    sitting.settle(1);
    ASSERT_EQ(names(folder / "state/recovery").size(), 2U);
    EXPECT_TRUE(sitting.quit());
    EXPECT_TRUE(names(folder / "state/recovery").empty());
}

// --- shortcuts
// ------------------------------------------------------------------------------------

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
