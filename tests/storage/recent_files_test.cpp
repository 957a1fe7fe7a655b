// The list of recent files, which all editors share.
#include "sitting.h"

#include "app/storage/recent_files.h"

namespace splineloft::app {
namespace {

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

} // namespace
} // namespace splineloft::app
