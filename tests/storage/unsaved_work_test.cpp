// Unsaved work is offered at the next start.
#include "sitting.h"
#include "ui/commands.h"

#include <csignal>
#include <sys/wait.h>

namespace splineloft::app {
namespace {

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

} // namespace
} // namespace splineloft::app
