// The offer of unsaved work, the list of recent files, and choosing files in the system's dialog:
// what the person sees and what is asked of the program.
#include "driver.h"
#include "hand.h"

#include "ui/commands.h"
#include "ui/file_choice.h"

#include <gtest/gtest.h>

namespace splineloft::ui {
namespace {

UnsavedWork workOf(const std::string& id, const std::string& path) {
    const Document document = documentOf({curveOf("cardinal"), curveOf("natural")});
    return {id, path, WallTime(), 2, 14, thumbnailOf(document)};
}

Widget inOffer(const std::string& id, const std::string& label) {
    return {"###dialog/work", {id, label}};
}

bool offers(const Driver& driver) {
    return driver.session.dialog && std::holds_alternative<RecoveryOffer>(*driver.session.dialog);
}

/// An editor that was just started and found some work.
struct Start : Driver {
    Start() {
        session.unsavedWork = {workOf("one", "/there/path.json"), workOf("two", "")};
        session.dialog = RecoveryOffer{};
        frames(3);
    }
};

TEST(Thumbnail, fitsItsBoxWhateverTheCurve) {
    std::vector<Document> documents = {{},
                                       documentOf({curveOf("cardinal", 1)}),
                                       documentOf({curveOf("cardinal", 3), curveOf("bezier")})};
    Curve lone = curveOf("linear");
    lone.points = {{3, 4}};
    documents.push_back(documentOf({lone}));
    Curve many = curveOf("linear");
    many.points = Points(2);
    for (int i = 0; i < 30'000; ++i) {
        many.points.append(Point{3e4 * i, 1e6 * (i % 7)});
    }
    documents.push_back(documentOf({many}));
    for (const auto& document : documents) {
        std::size_t places = 0;
        for (const auto& line : thumbnailOf(document)) {
            places += line.size();
            for (const auto& p : line) {
                EXPECT_TRUE(p.x >= 0 && p.x <= thumbnailWidth) << p.x;
                EXPECT_TRUE(p.y >= 0 && p.y <= thumbnailHeight) << p.y;
            }
        }
        EXPECT_LT(places, 5000U);
    }
    EXPECT_EQ(thumbnailOf(documents[2]).size(), 2U);
    EXPECT_GT(thumbnailOf(documents[2])[0].size(), 10U);
}

TEST(UnsavedWorkOffer, restoresOne) {
    Start start;
    start.click(inOffer("two", "Restore"));
    ASSERT_TRUE(lastRequest<RestoreWork>(start));
    EXPECT_EQ(lastRequest<RestoreWork>(start)->id, "two");
    EXPECT_FALSE(start.session.dialog);
    EXPECT_EQ(start.faults(), "");
}

TEST(UnsavedWorkOffer, discardsOneAndGoesOnOfferingTheOther) {
    Start start;
    start.click(inOffer("one", "Discard"));
    ASSERT_TRUE(lastRequest<DiscardWork>(start));
    EXPECT_EQ(lastRequest<DiscardWork>(start)->id, "one");
    start.session.unsavedWork.erase(start.session.unsavedWork.begin());
    start.frames(2);
    EXPECT_TRUE(offers(start));
    EXPECT_FALSE(start.has(inOffer("one", "Discard")));
    start.click(inOffer("two", "Discard"));
    start.session.unsavedWork.clear();
    start.frames(2);
    EXPECT_FALSE(start.session.dialog) << "there is nothing left to offer";
}

TEST(UnsavedWorkOffer, canWaitAndComesBackFromTheMenu) {
    Start start;
    start.click(inDialog("Later"));
    EXPECT_FALSE(start.session.dialog);
    EXPECT_TRUE(start.session.requests.empty());
    const auto& command = commandNamed("file.unsavedWork");
    ASSERT_TRUE(command.possible(start.session));
    command.run(start.session);
    start.frames(2);
    EXPECT_TRUE(start.has(inOffer("one", "Restore")));
    start.key(Key::escape);
    EXPECT_FALSE(start.session.dialog);
}

TEST(UnsavedWorkOffer, asksBeforeItLeavesOtherChangesBehind) {
    Driver driver(documentOf({curveOf("cardinal")}));
    driver.drag(driver.atPoint(3), driver.at({2, 2}));
    ASSERT_TRUE(driver.session.unsaved());
    driver.session.unsavedWork = {workOf("one", "/there/path.json")};
    driver.session.dialog = RecoveryOffer{};
    driver.frames(3);
    driver.click(inOffer("one", "Restore"));
    ASSERT_TRUE(driver.session.dialog);
    EXPECT_TRUE(std::holds_alternative<UnsavedQuestion>(*driver.session.dialog));
    driver.frames(2);
    driver.click(inDialog("Don't save"));
    EXPECT_TRUE(lastRequest<RestoreWork>(driver));
}

TEST(UnsavedWorkOffer, fitsASmallWindowWithMuchToOffer) {
    Driver driver({}, {720, 480, 1});
    for (int i = 0; i < 30; ++i) {
        driver.session.unsavedWork.push_back(workOf(std::to_string(i), "/there/path.json"));
    }
    driver.session.dialog = RecoveryOffer{};
    driver.frames(4);
    const auto later = driver.find(inDialog("Later"));
    ASSERT_TRUE(later);
    EXPECT_LT(later->bottom(), 480);
}

TEST(Restored, isUnsavedAndCanBeUndone) {
    Driver driver;
    const Document inFile = documentOf({curveOf("natural")});
    const Document work = documentOf({curveOf("cardinal")});
    driver.session.restored(work, "/there/path.json", inFile);
    driver.frames(2);
    EXPECT_TRUE(driver.session.unsaved());
    EXPECT_EQ(driver.session.document(), work);
    EXPECT_EQ(driver.result.title, "path.json ● - Splineloft");
    driver.key(Key::z, withControl);
    EXPECT_EQ(driver.session.document(), inFile);
    EXPECT_FALSE(driver.session.unsaved());
    EXPECT_EQ(driver.faults(), "");
}

TEST(RecentFiles, standInTheBrowserIfTheyAreThere) {
    Driver driver(documentOf({curveOf("cardinal")}));
    driver.session.path = "/no/such/folder/one.json";
    driver.session.recent = {{"/there/path.json", true}, {"/gone/other.json", false}};
    driver.key(Key::o, withControl);
    driver.frames(3);
    const auto entry = [](const std::string& path) {
        return Widget{"###dialog/files", {nameWithFolder(path)}};
    };
    EXPECT_FALSE(driver.has(entry("/gone/other.json")));
    driver.click(entry("/there/path.json"));
    ASSERT_TRUE(lastRequest<OpenFiles>(driver));
    EXPECT_EQ(lastRequest<OpenFiles>(driver)->paths,
              (std::vector<std::string>{"/there/path.json"}));
}

TEST(RecentFiles, haveAMenuThatLooksForThemWhenItOpens) {
    Driver driver(documentOf({curveOf("cardinal")}));
    driver.session.recent = {{"/there/path.json", true}, {"/gone/other.json", false}};
    driver.takeFromMenu(0, 2);
    driver.frames(3);
    ASSERT_TRUE(lastRequest<LookForRecent>(driver));
    driver.session.requests.clear();
    driver.frames(3);
    EXPECT_TRUE(driver.session.requests.empty()) << "only when it opens";
    const auto inMenu = [](std::string label) { return Widget{"##Menu_01", {std::move(label)}}; };
    driver.click(inMenu(nameWithFolder("/gone/other.json")));
    EXPECT_TRUE(driver.session.requests.empty()) << "what is gone cannot be opened";
    driver.click(inMenu(nameWithFolder("/there/path.json")));
    EXPECT_TRUE(lastRequest<OpenFiles>(driver));
}

TEST(RecentFiles, canBeForgotten) {
    Driver driver(documentOf({curveOf("cardinal")}));
    driver.session.recent = {{"/there/path.json", true}};
    driver.takeFromMenu(0, 2);
    driver.frames(3);
    driver.click(Widget{"##Menu_01", {"Clear the list"}});
    EXPECT_TRUE(lastRequest<ForgetRecent>(driver));
}

TEST(SystemDialog, takesThePlaceOfTheBrowserExceptForSamples) {
    Driver driver(documentOf({curveOf("cardinal")}));
    driver.session.systemDialogsFound = true;
    driver.key(Key::o, withControl);
    ASSERT_TRUE(lastRequest<AskForFile>(driver));
    EXPECT_EQ(lastRequest<AskForFile>(driver)->browser.purpose, FilePurpose::open);
    EXPECT_FALSE(driver.session.dialog);
    driver.key(Key::s, {.shift = true, .control = true});
    EXPECT_EQ(lastRequest<AskForFile>(driver)->browser.name, "untitled.json");
    driver.session.requests.clear();
    driver.key(Key::e, withControl);
    EXPECT_TRUE(driver.session.requests.empty());
    EXPECT_TRUE(driver.session.dialog) << "how many samples, only the browser asks";
    driver.key(Key::escape);
    driver.session.habits.systemDialogs = false;
    driver.key(Key::o, withControl);
    EXPECT_TRUE(driver.session.requests.empty());
    EXPECT_TRUE(driver.session.dialog);
}

TEST(SystemDialog, aNameWithoutItsEndingIsAskedAboutWhereThatFileIsThere) {
    Session session;
    FileBrowser browser;
    browser.purpose = FilePurpose::save;
    acceptFromSystem(session, browser, "/there/fresh");
    ASSERT_EQ(session.requests.size(), 1U);
    EXPECT_EQ(std::get<SaveFile>(session.requests[0]).path, "/there/fresh.json");
    const auto folder = std::filesystem::path(SPLINELOFT_TESTS_DIR) / "golden";
    session.requests.clear();
    acceptFromSystem(session, browser, folder / "bezier");
    EXPECT_TRUE(session.requests.empty()) << "nobody was asked about bezier.json";
    ASSERT_TRUE(session.dialog);
    EXPECT_TRUE(std::get<FileBrowser>(*session.dialog).overwriteAsked);
    acceptFromSystem(session, browser, folder / "bezier.json");
    EXPECT_EQ(session.requests.size(), 1U) << "about this one the dialog did ask";
}

} // namespace
} // namespace splineloft::ui
