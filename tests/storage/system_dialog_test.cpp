// The system's dialog, played by scripts that are called as the real programs are.
#include "app/storage/keeper.h"
#include "app/storage/system_dialog.h"
#include "temporary_folder.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace splineloft::app {
namespace {

/// A PATH with one such program on it, and a display to show it on.
class SystemDialogs : public testing::Test {
  protected:
    void SetUp() override {
        ::setenv("PATH", folder_.path().c_str(), 1);
        ::setenv("DISPLAY", ":0", 1);
        ::unsetenv("SPLINELOFT_DIALOG");
        ::unsetenv("XDG_CURRENT_DESKTOP");
    }
    void TearDown() override {
        ::setenv("PATH", path_.c_str(), 1);
        ::unsetenv("DISPLAY");
        ::unsetenv("WAYLAND_DISPLAY");
    }

    void install(const std::string& name, const std::string& script) {
        put(folder_ / name, "#!/bin/sh\nPATH=" + path_ + "\n" + script + "\n");
        fs::permissions(folder_ / name, fs::perms::owner_all);
    }

    /// What comes of a dialog.
    SystemDialog::Answer answer(const ui::FileBrowser& browser) {
        SystemDialog dialog;
        dialog.ask(folder_ / "zenity", browser);
        for (int i = 0; i < 5000; ++i) {
            if (auto found = dialog.answer()) {
                EXPECT_FALSE(dialog.asking());
                return *found;
            }
            ::usleep(1000);
        }
        ADD_FAILURE() << "no answer";
        return {SystemDialog::End::failed, {}, {}};
    }

    TemporaryFolder folder_;
    std::string path_ = std::getenv("PATH");
};

TEST_F(SystemDialogs, areLookedForOnThePath) {
    EXPECT_FALSE(systemDialogProgram());
    install("kdialog", "");
    EXPECT_EQ(systemDialogProgram(), folder_ / "kdialog");
    install("zenity", "");
    EXPECT_EQ(systemDialogProgram(), folder_ / "zenity");
    ::setenv("XDG_CURRENT_DESKTOP", "KDE", 1);
    EXPECT_EQ(systemDialogProgram(), folder_ / "kdialog");
    ::setenv("SPLINELOFT_DIALOG", "own", 1);
    EXPECT_FALSE(systemDialogProgram());
    ::unsetenv("SPLINELOFT_DIALOG");
    ::unsetenv("DISPLAY");
    EXPECT_FALSE(systemDialogProgram()) << "no display";
    ::setenv("WAYLAND_DISPLAY", "wayland-0", 1);
    EXPECT_TRUE(systemDialogProgram());
}

TEST_F(SystemDialogs, tellWhichFileWasChosen) {
    install("zenity", "printf '%s\\n' \"$@\" > " + (folder_ / "called").string() +
                          "; sleep 0.1; printf '/there/a file\\nwith two lines.json\\n'");
    ui::FileBrowser browser;
    browser.purpose = ui::FilePurpose::save;
    browser.folder = "/there";
    browser.name = "path.json";
    const auto found = answer(browser);
    EXPECT_EQ(found.end, SystemDialog::End::chosen);
    EXPECT_EQ(found.path, "/there/a file\nwith two lines.json");
    EXPECT_EQ(found.browser.name, "path.json");
    const auto called = contents(folder_ / "called");
    EXPECT_NE(called.find("--filename=/there/path.json\n"), std::string::npos) << called;
    EXPECT_NE(called.find("--save\n"), std::string::npos) << called;
}

TEST_F(SystemDialogs, canBeCancelledAndCanFail) {
    install("zenity", "sleep 0.3; exit 1");
    EXPECT_EQ(answer({}).end, SystemDialog::End::cancelled);
    install("zenity", "exit 1");
    EXPECT_EQ(answer({}).end, SystemDialog::End::failed) << "no hand is as fast as that";
    install("zenity", "exit 255");
    EXPECT_EQ(answer({}).end, SystemDialog::End::failed);
    install("zenity", "exit 0");
    EXPECT_EQ(answer({}).end, SystemDialog::End::failed) << "no file named";
    install("zenity", "kill -9 $$");
    EXPECT_EQ(answer({}).end, SystemDialog::End::failed);
    fs::remove(folder_ / "zenity");
    EXPECT_EQ(answer({}).end, SystemDialog::End::failed);
}

TEST_F(SystemDialogs, doNotHoldUpTheEditor) {
    install("zenity", "exec sleep 1000");
    SystemDialog dialog;
    dialog.ask(folder_ / "zenity", {});
    for (int i = 0; i < 50; ++i) {
        EXPECT_FALSE(dialog.answer());
    }
    EXPECT_TRUE(dialog.asking());
    dialog.close();
    EXPECT_FALSE(dialog.asking());
}

TEST_F(SystemDialogs, openWhatWasChosenInTheSession) {
    put(folder_ / "a.json", writeDocument(documentWith(4)));
    install("zenity", "sleep 0.1; echo " + (folder_ / "a.json").string());
    Keeper keeper({});
    ui::Session session;
    keeper.begin(session, {});
    ASSERT_TRUE(session.systemDialogsFound);
    session.browse(ui::FilePurpose::open);
    for (int i = 0; i < 5000 && session.path.empty(); ++i) {
        ASSERT_TRUE(keeper.afterFrame(session, {}));
        ::usleep(1000);
    }
    EXPECT_EQ(session.document(), documentWith(4));
    EXPECT_EQ(keeper.patience(), 0) << "a frame has yet to show it";
    EXPECT_TRUE(keeper.attend(session));
    EXPECT_EQ(keeper.patience(), never);
}

TEST_F(SystemDialogs, thatFailGiveWayToTheBrowserForTheRestOfTheSitting) {
    install("zenity", "exit 5");
    Keeper keeper({});
    ui::Session session;
    keeper.begin(session, {});
    session.browse(ui::FilePurpose::open);
    for (int i = 0; i < 5000 && !session.dialog; ++i) {
        ASSERT_TRUE(keeper.afterFrame(session, {}));
        ::usleep(1000);
    }
    ASSERT_TRUE(session.dialog);
    EXPECT_TRUE(session.notice->isProblem);
    session.browse(ui::FilePurpose::save);
    EXPECT_TRUE(session.requests.empty());
}

} // namespace
} // namespace splineloft::app
