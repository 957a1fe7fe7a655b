// The messages of a sitting and the panel that shows them.
#include "driver.h"
#include "hand.h"

#include "ui/commands.h"

#include <gtest/gtest.h>
#include <imgui.h>

namespace splineloft::ui {
namespace {

TEST(Log, keepsWhatWasSaid) {
    Session session;
    session.say("one");
    session.complain("two");
    session.notice.reset();
    ASSERT_EQ(session.log.messages().size(), 2U);
    EXPECT_EQ(session.log.messages()[0].text, "one");
    EXPECT_FALSE(session.log.messages()[0].isProblem);
    EXPECT_TRUE(session.log.messages()[1].isProblem);
}

TEST(Log, countsWhatIsSaidOverAndOver) {
    Session session;
    for (int i = 0; i < 50; ++i) {
        session.complain("no");
    }
    ASSERT_EQ(session.log.messages().size(), 1U);
    EXPECT_EQ(session.log.messages()[0].times, 50);
}

TEST(Log, keepsTheLatest) {
    Session session;
    for (int i = 0; i < 1000; ++i) {
        session.say(std::to_string(i));
    }
    EXPECT_EQ(session.log.messages().size(), Log::most);
    EXPECT_EQ(session.log.messages().back().text, "999");
}

TEST(Log, hasAPanelOverTheStripWithACopy) {
    Driver driver(documentOf({curveOf("cardinal")}));
    driver.session.say("first");
    driver.session.complain("second");
    EXPECT_FALSE(driver.has(Widget{"log", {"Copy"}}));
    commandNamed("view.log").run(driver.session);
    driver.frames(3);
    driver.click(Widget{"log", {"Copy"}});
    const std::string copied = ImGui::GetClipboardText();
    EXPECT_NE(copied.find("first\n"), std::string::npos) << copied;
    EXPECT_NE(copied.find("! second\n"), std::string::npos) << copied;
    driver.click(Widget{"log", {"Close"}});
    EXPECT_FALSE(driver.session.view.log);
    driver.frames(2);
    EXPECT_FALSE(driver.has(Widget{"log", {"Copy"}}));
    EXPECT_EQ(driver.faults(), "");
}

TEST(Log, isShownWithoutTheStripToo) {
    Driver driver;
    driver.session.view.layers.basis = false;
    driver.session.view.log = true;
    driver.frames(3);
    EXPECT_TRUE(driver.has(Widget{"log", {"Copy"}}));
}

} // namespace
} // namespace splineloft::ui
