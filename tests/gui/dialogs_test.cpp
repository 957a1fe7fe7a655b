// Leaving a document behind, and files: the question, the browser, what is asked of the program.
#include "driver.h"
#include "hand.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <unistd.h>

namespace splineloft::ui {
namespace {

namespace fs = std::filesystem;

/// A folder of its own with a few files in it.
class Folder {
  public:
    Folder() : path_(fs::temp_directory_path() / ("splineloft-gui-" + std::to_string(::getpid()))) {
        fs::remove_all(path_);
        fs::create_directories(path_ / "inner");
        for (const char* name :
             {"one.json", "two.json", "table.csv", ".hidden.json", "notes.txt"}) {
            std::ofstream(path_ / name) << "{}";
        }
    }
    ~Folder() { fs::remove_all(path_); }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    std::string operator/(const std::string& name) const { return (path_ / name).string(); }

  private:
    fs::path path_;
};

void change(Driver& driver) {
    driver.drag(driver.atPoint(3), driver.at({2, 2}));
    ASSERT_TRUE(driver.session.unsaved());
}

/// Changes the document, closes the window and answers "Save".
void closeSaving(Driver& driver) {
    change(driver);
    driver.send(CloseAsked{});
    driver.click(inDialog("Save"));
}

template <class Wanted> bool shows(const Driver& driver) {
    return driver.session.dialog && std::holds_alternative<Wanted>(*driver.session.dialog);
}

TEST(Leaving, withoutChangesNothingIsAsked) {
    Driver driver(plain());
    driver.send(CloseAsked{});
    EXPECT_TRUE(lastRequest<Quit>(driver));
    driver.key(Key::n, withControl);
    EXPECT_FALSE(driver.session.dialog);
    EXPECT_TRUE(driver.session.document().curves.empty());
    EXPECT_EQ(driver.session.view.tool, Tool::pen) << "a new document is there to be drawn in";
}

TEST(Leaving, withChangesItIsAskedFirst) {
    for (const char* way : {"close", "quit", "new", "open", "drop"}) {
        Driver driver(plain());
        change(driver);
        const Document changed = driver.session.document();
        switch (way[0]) {
        case 'c': driver.send(CloseAsked{}); break;
        case 'q': driver.key(Key::q, withControl); break;
        case 'n': driver.key(Key::n, withControl); break;
        case 'o': driver.key(Key::o, withControl); break;
        default: driver.send(FilesDropped{{"/there/dropped.json"}});
        }
        ASSERT_TRUE(shows<UnsavedQuestion>(driver)) << way;
        EXPECT_TRUE(driver.session.requests.empty()) << way;
        driver.click(inDialog("Cancel"));
        EXPECT_FALSE(driver.session.dialog) << way;
        EXPECT_TRUE(driver.session.requests.empty()) << way;
        EXPECT_EQ(driver.session.document(), changed) << way;
    }
}

TEST(Leaving, dontSaveGoesOnAtOnce) {
    Driver driver(plain());
    change(driver);
    driver.send(CloseAsked{});
    driver.click(inDialog("Don't save"));
    EXPECT_TRUE(lastRequest<Quit>(driver));
    EXPECT_FALSE(driver.session.dialog);
}

TEST(Leaving, saveSavesFirst) {
    Driver driver(plain());
    driver.session.path = "/there/known.json";
    closeSaving(driver);
    ASSERT_TRUE(lastRequest<SaveFile>(driver));
    EXPECT_EQ(lastRequest<SaveFile>(driver)->path, "/there/known.json");
    EXPECT_EQ(driver.session.requests.size(), 1U) << "not before it is saved";
    driver.session.wasSaved("/there/known.json");
    EXPECT_TRUE(lastRequest<Quit>(driver));
}

TEST(Leaving, aSaveThatFailsLeavesNothingBehind) {
    Driver driver(plain());
    driver.session.path = "/there/known.json";
    closeSaving(driver);
    driver.session.failed("the disk is full", std::nullopt);
    driver.key(Key::s, withControl);
    driver.session.wasSaved("/there/known.json");
    EXPECT_FALSE(lastRequest<Quit>(driver)) << "that wish to quit is over";
}

TEST(Leaving, aSaveThatIsCalledOffDoesNotQuitLater) {
    Folder folder;
    Driver driver(plain());
    closeSaving(driver);
    ASSERT_TRUE(shows<FileBrowser>(driver)) << "it has no name yet";
    driver.frames(3);
    driver.click(inDialog("Cancel"));
    driver.key(Key::s, {.shift = true, .control = true});
    ASSERT_TRUE(shows<FileBrowser>(driver));
    driver.session.wasSaved(folder / "later.json");
    EXPECT_FALSE(lastRequest<Quit>(driver));
}

TEST(Leaving, escapeAnswersCancel) {
    Driver driver(plain());
    change(driver);
    driver.send(CloseAsked{});
    driver.key(Key::escape);
    EXPECT_FALSE(driver.session.dialog);
    EXPECT_TRUE(driver.session.requests.empty());
    EXPECT_TRUE(driver.session.unsaved());
}

TEST(Leaving, undoneChangesAreNone) {
    Driver driver(plain());
    change(driver);
    driver.key(Key::z, withControl);
    driver.send(CloseAsked{});
    EXPECT_TRUE(lastRequest<Quit>(driver));
}

TEST(Files, droppedFilesAreOpenedTogether) {
    Driver driver(plain());
    driver.send(FilesDropped{{"/there/dropped.json", "/there/other.json"}});
    ASSERT_TRUE(lastRequest<OpenFiles>(driver));
    EXPECT_EQ(lastRequest<OpenFiles>(driver)->paths,
              (std::vector<std::string>{"/there/dropped.json", "/there/other.json"}));
    driver.send(FilesDropped{{}});
    EXPECT_EQ(driver.session.requests.size(), 1U) << "nothing dropped, nothing opened";
}

TEST(Files, aFileDroppedOnADialogTakesItsPlaceAndTheCanvasIsFreeAgain) {
    Driver driver(plain());
    driver.key(Key::f1);
    driver.send(FilesDropped{{"/there/dropped.json"}});
    ASSERT_TRUE(lastRequest<OpenFiles>(driver));
    driver.session.opened(plain(), "/there/dropped.json");
    driver.frames(3);
    driver.key(Key::k);
    EXPECT_TRUE(driver.session.view.layers.comb) << "and keys are shortcuts again";
    driver.click(driver.atPoint(2));
    EXPECT_EQ(driver.session.view.selection, (Selection{{0, 2}}));
}

TEST(Files, savingUnderAKnownNameAsksNothing) {
    Driver driver(plain());
    driver.session.path = "/there/known.json";
    driver.key(Key::s, withControl);
    ASSERT_TRUE(lastRequest<SaveFile>(driver));
    EXPECT_FALSE(driver.session.dialog);
}

TEST(Files, savingWhatHasNoNameAsksForOne) {
    Folder folder;
    Driver driver(plain());
    driver.key(Key::s, withControl);
    driver.frames(3);
    const auto* browser = std::get_if<FileBrowser>(&*driver.session.dialog);
    ASSERT_TRUE(browser);
    EXPECT_EQ(browser->purpose, FilePurpose::save);
    driver.key(Key::a, withControl);
    driver.type(folder / "first.json");
    driver.key(Key::enter);
    ASSERT_TRUE(lastRequest<SaveFile>(driver));
    EXPECT_EQ(lastRequest<SaveFile>(driver)->path, folder / "first.json");
}

TEST(Files, theBrowserSavesUnderTheTypedName) {
    Folder folder;
    Driver driver(plain());
    driver.session.path = folder / "one.json";
    driver.key(Key::s, {.shift = true, .control = true});
    driver.frames(3);
    driver.key(Key::a, withControl);
    driver.type("fresh");
    driver.key(Key::enter);
    ASSERT_TRUE(lastRequest<SaveFile>(driver));
    EXPECT_EQ(lastRequest<SaveFile>(driver)->path, folder / "fresh.json") << "with its ending";
    EXPECT_FALSE(driver.session.dialog);
    EXPECT_EQ(driver.steps(), 0) << "nothing that was typed was a shortcut";
}

TEST(Files, whereASaveFailsTheBrowserIsThereAgainWithTheNameAndTheReason) {
    Folder folder;
    Driver driver(plain());
    closeSaving(driver);
    driver.frames(3);
    driver.key(Key::a, withControl);
    driver.type(folder / "gone/first.json");
    driver.key(Key::enter);
    ASSERT_TRUE(lastRequest<SaveFile>(driver));
    const auto asked = *lastRequest<SaveFile>(driver);
    driver.session.requests.clear();
    driver.session.failed("there is no such folder", asked.chosenIn);
    driver.frames(3);
    ASSERT_TRUE(shows<FileBrowser>(driver));
    EXPECT_EQ(std::get<FileBrowser>(*driver.session.dialog).name, folder / "gone/first.json");
    EXPECT_EQ(std::get<FileBrowser>(*driver.session.dialog).problem, "there is no such folder");
    driver.key(Key::a, withControl);
    driver.type(folder / "first.json");
    EXPECT_EQ(std::get<FileBrowser>(*driver.session.dialog).problem, "") << "of another name";
    driver.key(Key::enter);
    ASSERT_TRUE(lastRequest<SaveFile>(driver));
    driver.session.wasSaved(folder / "first.json");
    EXPECT_TRUE(lastRequest<Quit>(driver)) << "what the save was for is not forgotten";
}

TEST(Files, whatIsThereIsReplacedOnlyAfterAsking) {
    Folder folder;
    Driver driver(plain());
    driver.session.path = folder / "one.json";
    driver.key(Key::s, {.shift = true, .control = true});
    driver.frames(3);
    driver.click(inDialog("Save"));
    EXPECT_TRUE(driver.session.requests.empty());
    ASSERT_TRUE(shows<FileBrowser>(driver));
    driver.frames(2);
    driver.click(inDialog("Replace it"));
    ASSERT_TRUE(lastRequest<SaveFile>(driver));
    EXPECT_EQ(lastRequest<SaveFile>(driver)->path, folder / "one.json");
}

TEST(Files, whatIsThereIsReplacedByASecondEnter) {
    Folder folder;
    Driver driver(plain());
    driver.session.path = folder / "one.json";
    driver.key(Key::s, {.shift = true, .control = true});
    driver.frames(3);
    driver.key(Key::enter);
    EXPECT_TRUE(driver.session.requests.empty());
    ASSERT_TRUE(shows<FileBrowser>(driver));
    driver.frames(2);
    driver.key(Key::enter);
    ASSERT_TRUE(lastRequest<SaveFile>(driver));
    EXPECT_EQ(lastRequest<SaveFile>(driver)->path, folder / "one.json");
}

TEST(Files, anotherNameAsksAnew) {
    Folder folder;
    Driver driver(plain());
    driver.session.path = folder / "one.json";
    driver.key(Key::s, {.shift = true, .control = true});
    driver.frames(3);
    driver.click(inDialog("Save"));
    driver.click(Widget{"###dialog/files", {"    two.json"}});
    ASSERT_TRUE(shows<FileBrowser>(driver));
    EXPECT_EQ(std::get<FileBrowser>(*driver.session.dialog).name, "two.json");
    driver.frames(2);
    ASSERT_FALSE(driver.has(inDialog("Replace it"))) << "two.json was not asked about";
    driver.click(inDialog("Save"));
    EXPECT_TRUE(driver.session.requests.empty());
}

TEST(Files, theBrowserShowsDocumentsAndFoldersAndOpensWhatIsDoubleClicked) {
    Folder folder;
    Driver driver(plain());
    driver.session.path = folder / "one.json";
    driver.key(Key::o, withControl);
    driver.frames(3);
    const auto entry = [](const std::string& name) { return Widget{"###dialog/files", {name}}; };
    EXPECT_FALSE(driver.has(entry("    .hidden.json")));
    EXPECT_FALSE(driver.has(entry("    notes.txt")));
    EXPECT_FALSE(driver.has(entry("    table.csv")));
    driver.click(entry("▸  inner"));
    EXPECT_EQ(std::get<FileBrowser>(*driver.session.dialog).folder.filename(), "inner");
    driver.click(entry("↑  .."));
    driver.doubleClick(driver.middle(entry("    two.json")));
    ASSERT_TRUE(lastRequest<OpenFiles>(driver));
    EXPECT_EQ(lastRequest<OpenFiles>(driver)->paths, std::vector{folder / "two.json"});
    EXPECT_FALSE(driver.session.dialog);
}

TEST(Files, samplesAreExportedAsAsked) {
    Folder folder;
    Driver driver(plain());
    driver.session.path = folder / "one.json";
    driver.key(Key::e, withControl);
    driver.frames(3);
    driver.click(Widget{"###dialog", {"even", "even in u"}});
    driver.click(inDialog("samples"));
    driver.key(Key::a, withControl);
    driver.type("37");
    driver.key(Key::tab);
    driver.click(inDialog("Export"));
    const auto* asked = lastRequest<ExportSamples>(driver);
    ASSERT_TRUE(asked);
    EXPECT_EQ(asked->path, folder / "one-samples.csv");
    EXPECT_EQ(asked->even, Even::parameter);
    EXPECT_EQ(asked->count, 37);
}

TEST(Files, aFolderThatCannotBeReadIsJustEmpty) {
    Driver driver(plain());
    driver.session.path = "/no/such/folder/one.json";
    driver.key(Key::o, withControl);
    driver.frames(3);
    EXPECT_TRUE(shows<FileBrowser>(driver));
    driver.click(inDialog("Open"));
    EXPECT_TRUE(driver.session.requests.empty()) << "no name, no file";
    driver.click(inDialog("Cancel"));
    EXPECT_FALSE(driver.session.dialog);
}

TEST(Files, theTitleTellsWhatIsUnsaved) {
    Driver driver(plain());
    EXPECT_EQ(driver.result.title, "untitled - Splineloft");
    driver.session.path = "/there/known.json";
    change(driver);
    EXPECT_EQ(driver.result.title, "known.json ● - Splineloft");
    driver.session.wasSaved("/there/known.json");
    driver.frames(1);
    EXPECT_EQ(driver.result.title, "known.json - Splineloft");
    driver.key(Key::z, withControl);
    EXPECT_EQ(driver.result.title, "known.json ● - Splineloft") << "undone is unsaved too";
}

} // namespace
} // namespace splineloft::ui
