// Settings from one sitting to the next.
#include "sitting.h"
#include "tests/unit/child_process.h"

#include <sys/stat.h>

namespace splineloft::app {
namespace {

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

} // namespace
} // namespace splineloft::app
