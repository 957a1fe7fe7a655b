// Unsaved work: kept soon enough, found by the next editor and by it alone, gone once it is saved.
#include "app/storage/autosave.h"
#include "app/storage/file_lock.h"
#include "core/formats/file.h"
#include "temporary_folder.h"
#include "tests/unit/child_process.h"

#include <gtest/gtest.h>

#include <sys/file.h>

namespace splineloft::app {
namespace {

/// An editor's sitting as far as the autosave sees it, with a clock that is set by hand.
class WatchedSitting {
  public:
    explicit WatchedSitting(const fs::path& folder, AutosavePace pace = {})
        : autosave(folder, pace), session(documentWith(0), "") {
        look();
    }

    void look() { autosave.look(session, now); }
    /// Lets time pass as the loop does: looks whenever it was asked to.
    void pass(double seconds) {
        const auto end = after(now, seconds);
        while (autosave.patience(now) <= secondsUntil(end, now)) {
            const double wait = autosave.patience(now);
            ::usleep(1000); // the disk has its own clock
            now = after(now, std::max(wait, 1e-3));
            look();
        }
        now = end;
        look();
        // The clock is set by hand, the disk is not: it may still be at work.
        while (autosave.patience(now) == Writer::askAgain) {
            ::usleep(1000);
            look();
        }
    }

    Moment now = Clock::now();
    Autosave autosave;
    ui::Session session;
};

std::vector<FoundWork> find(const fs::path& folder) {
    std::vector<std::string> problems;
    auto found = findUnsavedWork(folder, problems);
    EXPECT_TRUE(problems.empty()) << problems.front();
    return found;
}

/// What an editor with these changes leaves when it is killed at the end of `sit`.
void dieAfter(const std::function<void()>& sit) {
    const auto child = ::fork();
    if (child == 0) {
        sit();
        ::kill(::getpid(), SIGKILL);
    }
    ::waitpid(child, nullptr, 0);
}

TEST(Autosave, waitsForeverWhileNothingIsUnsaved) {
    const TemporaryFolder folder;
    WatchedSitting sitting(folder / "recovery");
    EXPECT_EQ(sitting.autosave.patience(sitting.now), never);
    EXPECT_TRUE(names(folder.path()).empty());
    change(sitting.session, 1);
    sitting.session.undo();
    sitting.look();
    EXPECT_EQ(sitting.autosave.patience(sitting.now), never) << "undone is not unsaved";
}

TEST(Autosave, keepsAChangeWithinTwentySeconds) {
    const TemporaryFolder folder;
    WatchedSitting sitting(folder / "recovery");
    change(sitting.session, 1);
    sitting.look();
    EXPECT_NEAR(sitting.autosave.patience(sitting.now), 20, 1e-6);
    sitting.pass(19.9);
    EXPECT_TRUE(names(folder / "recovery").empty());
    sitting.pass(1);
    EXPECT_EQ(names(folder / "recovery").size(), 2U) << "a document and its lock";
    EXPECT_EQ(sitting.autosave.patience(sitting.now), never) << "and then rests";
}

TEST(Autosave, keepsTwentyChangesAtOnce) {
    const TemporaryFolder folder;
    WatchedSitting sitting(folder / "recovery");
    for (int i = 1; i <= 20; ++i) {
        EXPECT_TRUE(names(folder / "recovery").empty());
        change(sitting.session, i);
        sitting.look();
    }
    sitting.pass(0.5);
    EXPECT_EQ(names(folder / "recovery").size(), 2U);
}

TEST(Autosave, forgetsWhatIsSavedOrGivenUp) {
    const TemporaryFolder folder;
    for (const char* way : {"saved", "undone", "another document", "the end"}) {
        WatchedSitting sitting(folder / "recovery", {1, 20});
        change(sitting.session, 1);
        sitting.look();
        sitting.pass(1);
        ASSERT_EQ(names(folder / "recovery").size(), 2U) << way;
        switch (way[0]) {
        case 's': sitting.session.wasSaved("/there/file.json"); break;
        case 'u': sitting.session.undo(); break;
        case 'a': sitting.session.opened(documentWith(5), "/there/other.json"); break;
        default: sitting.autosave.end();
        }
        sitting.look();
        EXPECT_TRUE(names(folder / "recovery").empty()) << way;
    }
}

TEST(Autosave, anotherDocumentHasAPlaceOfItsOwn) {
    const TemporaryFolder folder;
    dieAfter([&] {
        WatchedSitting sitting(folder / "recovery", {1, 20});
        change(sitting.session, 1);
        sitting.look();
        sitting.pass(1);
        sitting.session.opened(documentWith(5), "/there/other.json");
        change(sitting.session, 6);
        sitting.look();
        sitting.pass(1);
    });
    const auto found = find(folder / "recovery");
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].document, documentWith(6));
    EXPECT_EQ(found[0].offer.path, "/there/other.json");
}

TEST(Autosave, sensesADiskThatRefusesOnceAndTriesOnMoreSlowly) {
    const TemporaryFolder folder;
    put(folder / "recovery", "a file where a folder should be");
    WatchedSitting sitting(folder / "recovery");
    change(sitting.session, 1);
    sitting.look();
    sitting.pass(21);
    const auto complaint = sitting.autosave.takeComplaint();
    ASSERT_TRUE(complaint);
    EXPECT_NE(complaint->find("recovery"), std::string::npos) << *complaint;
    EXPECT_NEAR(sitting.autosave.patience(sitting.now), 40, 2);
    sitting.pass(3000);
    EXPECT_FALSE(sitting.autosave.takeComplaint()) << "said once";
    EXPECT_LE(sitting.autosave.patience(sitting.now), 600);
    EXPECT_TRUE(sitting.session.unsaved());
    fs::remove(folder / "recovery");
    sitting.pass(700);
    EXPECT_EQ(names(folder / "recovery").size(), 2U) << "at last";
}

TEST(Autosave, aFullDiskLeavesWhatWasKeptBefore) {
    const TemporaryFolder folder;
    const auto ending = inChild([] { return true; },
                                [&] {
                                    WatchedSitting sitting(folder / "recovery", {1, 20});
                                    change(sitting.session, 1);
                                    sitting.look();
                                    sitting.pass(1);
                                    limitFiles(100);
                                    change(sitting.session, 2);
                                    sitting.look();
                                    sitting.pass(1);
                                    return sitting.autosave.takeComplaint().value_or("nothing");
                                });
    EXPECT_NE(ending.said.find("too large"), std::string::npos) << ending.said;
    const auto found = find(folder / "recovery");
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].document, documentWith(1));
}

TEST(Recovery, offersWhatAKilledEditorHadInNoFile) {
    const TemporaryFolder folder;
    dieAfter([&] {
        WatchedSitting sitting(folder / "recovery", {1, 20});
        sitting.session.path = "/there/path.json";
        change(sitting.session, 7);
        sitting.look();
        sitting.pass(1);
    });
    const auto found = find(folder / "recovery");
    ASSERT_EQ(found.size(), 1U);
    const auto& offer = found[0].offer;
    EXPECT_EQ(found[0].document, documentWith(7));
    EXPECT_EQ(contents(found[0].slot->document()), writeDocument(documentWith(7)));
    EXPECT_EQ(offer.path, "/there/path.json");
    EXPECT_EQ(offer.curves, 1U);
    EXPECT_EQ(offer.points, 3U);
    EXPECT_LT(std::chrono::system_clock::now() - offer.time, std::chrono::minutes(1));
    ASSERT_EQ(offer.thumbnail.size(), 1U);
    EXPECT_GE(offer.thumbnail[0].size(), 3U);
    for (const auto& p : offer.thumbnail[0]) {
        EXPECT_TRUE(p.x >= 0 && p.x <= ui::thumbnailWidth && p.y >= 0 &&
                    p.y <= ui::thumbnailHeight);
    }
}

TEST(Recovery, offersWorkToOneEditorAtATime) {
    const TemporaryFolder folder;
    dieAfter([&] {
        WatchedSitting sitting(folder / "recovery", {1, 20});
        change(sitting.session, 7);
        sitting.look();
        sitting.pass(1);
    });
    {
        const auto first = find(folder / "recovery");
        EXPECT_EQ(first.size(), 1U);
        EXPECT_TRUE(find(folder / "recovery").empty()) << "the first editor decides";
    }
    EXPECT_EQ(find(folder / "recovery").size(), 1U) << "which it has not";
}

TEST(Recovery, leavesRunningEditorsAlone) {
    const TemporaryFolder folder;
    WatchedSitting sitting(folder / "recovery", {1, 20});
    change(sitting.session, 1);
    sitting.look();
    sitting.pass(1);
    const auto before = names(folder / "recovery");
    ASSERT_EQ(before.size(), 2U);
    EXPECT_TRUE(find(folder / "recovery").empty());
    EXPECT_EQ(names(folder / "recovery"), before);
}

TEST(Recovery, workThatIsInItsFileAfterAllIsNoLoss) {
    const TemporaryFolder folder;
    dieAfter([&] {
        WatchedSitting sitting(folder / "recovery", {1, 20});
        sitting.session.path = (folder / "path.json").string();
        change(sitting.session, 7);
        sitting.look();
        sitting.pass(1);
        [[maybe_unused]] const auto done =
            saveFile(folder / "path.json", writeDocument(documentWith(7)));
    });
    EXPECT_TRUE(find(folder / "recovery").empty());
    EXPECT_TRUE(names(folder / "recovery").empty());
}

TEST(Recovery, goesOnInThePlaceThatItWasRestoredFrom) {
    const TemporaryFolder folder;
    dieAfter([&] {
        WatchedSitting sitting(folder / "recovery", {1, 20});
        change(sitting.session, 7);
        sitting.look();
        sitting.pass(1);
    });
    dieAfter([&] {
        WatchedSitting sitting(folder / "recovery", {1, 20});
        auto found = find(folder / "recovery");
        sitting.session.restored(found.at(0).document, "", {});
        sitting.autosave.adopt(found.at(0).slot, sitting.session);
        sitting.look();
        sitting.pass(30);
    });
    auto found = find(folder / "recovery");
    ASSERT_EQ(found.size(), 1U) << "restored and not saved, it is still not lost";
    EXPECT_EQ(found[0].document, documentWith(7));
    WatchedSitting sitting(folder / "recovery", {1, 20});
    sitting.session.restored(found[0].document, "", {});
    sitting.autosave.adopt(std::move(found[0].slot), sitting.session);
    found.clear();
    change(sitting.session, 8);
    sitting.look();
    sitting.pass(1);
    EXPECT_EQ(names(folder / "recovery").size(), 2U);
    sitting.session.wasSaved("/there/file.json");
    sitting.look();
    EXPECT_TRUE(names(folder / "recovery").empty());
}

TEST(Recovery, whatCannotBeReadIsPutAsideAndTold) {
    const TemporaryFolder folder;
    put(folder / "recovery/1-2-3.json", "{\"format\": \"spl");
    put(folder / "recovery/1-2-3.lock", "{");
    put(folder / "recovery/4-5-6.lock", "");
    put(folder / "recovery/notes.txt", "mine");
    std::vector<std::string> problems;
    EXPECT_TRUE(findUnsavedWork(folder / "recovery", problems).empty());
    ASSERT_EQ(problems.size(), 1U);
    EXPECT_NE(problems[0].find("1-2-3.json.bad"), std::string::npos) << problems[0];
    EXPECT_EQ(names(folder / "recovery"), (std::set<std::string>{"1-2-3.json.bad", "notes.txt"}));
    problems.clear();
    EXPECT_TRUE(findUnsavedWork(folder / "recovery", problems).empty());
    EXPECT_TRUE(problems.empty()) << "said once";
}

TEST(Recovery, aFolderThatDoesNotExistHoldsNothing) {
    const TemporaryFolder folder;
    EXPECT_TRUE(find(folder / "missing").empty());
    EXPECT_TRUE(names(folder.path()).empty());
}

} // namespace
} // namespace splineloft::app
