// Saving: what fails says why and loses nothing.
#include "sitting.h"

#include "tests/unit/child_process.h"

#include <sys/stat.h>

namespace splineloft::app {
namespace {

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
            const bool saved = saveTo(session, {path.string()});
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
    EXPECT_TRUE(saveTo(session, {session.path}));
    EXPECT_TRUE(fs::is_symlink(folder / "path.json"));
    EXPECT_EQ(contents(folder / "target.json"), writeDocument(documentWith(2)));
    EXPECT_FALSE(session.unsaved());
}

} // namespace
} // namespace splineloft::app
