// One sitting at the editor: the document with its history, the way it is looked at, and what has
// been asked of the program around it. Edits come in through one door, `apply`.
#pragma once

#include "core/document/history.h"
#include "ui/canvas/gesture.h"
#include "ui/edit.h"
#include "ui/log.h"
#include "ui/recovery.h"
#include "ui/shortcut.h"
#include "ui/study.h"

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace splineloft::ui {

// --- choosing a file
// --------------------------------------------------------------------------------------

enum class FilePurpose { open, save, exportSamples };

/// The in-app file browser.
struct FileBrowser {
    FilePurpose purpose = FilePurpose::open;
    std::filesystem::path folder;
    std::string name;
    Even even = Even::length;
    int count = 100;
    bool overwriteAsked = false;
    std::string problem;       ///< why what was chosen last could not be done
    bool takesKeyboard = true; ///< the field for the name takes it with the next frame
    bool closed = false;       ///< the person has had enough of it
};

/// A file that was opened or saved before, and whether it is still there.
struct RecentFile {
    std::string path;
    bool isThere = true;
};

// --- what the program around the interface is asked to do
// --------------------------------------------

// `chosenIn` is the browser in which a file was chosen: it is shown again where the request fails.

/// Opens the first file that can be read, and adds the curves of the others.
struct OpenFiles {
    std::vector<std::string> paths;
    std::optional<FileBrowser> chosenIn = {};
};
struct SaveFile {
    std::string path;
    std::optional<FileBrowser> chosenIn = {};
};
/// Writes samples of the active curve, as JSON or CSV by the ending of the path.
struct ExportSamples {
    std::string path;
    Even even = Even::length;
    int count = 100;
    std::optional<FileBrowser> chosenIn = {};
};
/// Lets the system's dialog do what the browser would.
struct AskForFile {
    FileBrowser browser;
};
/// Looks which files were opened or saved lately, here and in other editors.
struct LookForRecent {};
struct ForgetRecent {};
/// Opens what an editor that died left unsaved, by its id, or throws it away.
struct RestoreWork {
    std::string id;
};
struct DiscardWork {
    std::string id;
};
struct ReadShortcuts {};
/// Makes the shortcuts file where there is none, and tells its path.
struct MakeShortcutsFile {};
struct Quit {};

using Request =
    std::variant<OpenFiles, SaveFile, ExportSamples, AskForFile, LookForRecent, ForgetRecent,
                 RestoreWork, DiscardWork, ReadShortcuts, MakeShortcutsFile, Quit>;

// --- what leaves the present document behind
// -----------------------------------------------------------

struct StartNew {};
/// Opens files; asks which where there are none.
struct GoToFiles {
    std::vector<std::string> paths;
};
using Departure = std::variant<StartNew, GoToFiles, RestoreWork, Quit>;

// --- what stands in front of everything else
// ------------------------------------------------------------

/// "Save the changes first?"
struct UnsavedQuestion {
    Departure departure;
};
struct KeyList {};
/// A field in which commands are found by a few letters.
struct Palette {
    std::array<char, 96> typed{}; ///< UTF-8, ended by 0
    std::size_t chosen = 0;       ///< row of the command that Enter runs
};
/// "This was in no file when the editor died."
struct RecoveryOffer {};
using Dialog = std::variant<FileBrowser, UnsavedQuestion, KeyList, Palette, RecoveryOffer>;

/// What the pointer was over when the right button was pressed.
enum class Context { point, curve, canvas };

/// The menu that this opens.
struct ContextMenu {
    Context context = Context::canvas;
    ScreenPoint at;
    bool shown = false; ///< it has been drawn since
};

/// A message in the status line; it stays until the next press of a button or key.
struct Notice {
    std::string text;
    bool isProblem = false;
};

/// A key that is down. Let go without having served, it was a tap.
struct HeldKey {
    Key key;
    Modifiers modifiers;
    bool served = false;
};

/// What is remembered from one start to the next besides the way of looking.
struct Habits {
    bool systemDialogs = true;                     ///< to choose files, rather than the browser
    double windowWidth = 1280, windowHeight = 800; ///< design pixels
};

class Session {
  public:
    explicit Session(Document document = {}, std::string path = "");

    const Document& document() const { return history.live(); }
    /// The active curve's study, or null where there is no curve.
    const Study* active() const;
    /// Whether there are changes that are in no file.
    bool unsaved() const { return !(history.settled() == saved_); }

    /// The only way into the document. Refuses, with a notice, what could not be drawn or saved.
    void apply(Edit edit);
    /// Ends what the hand is in the middle of and restores what was there before.
    void giveUpGesture();
    void undo();
    void redo();

    /// Leaves the document behind, after asking where something would be lost.
    void leave(Departure departure);
    /// Leaves it behind without asking.
    void leaveAnyway(const Departure& departure);
    /// Saves under the present path, or asks for one. Then departs, if that was the reason.
    void save(std::optional<Departure> then = std::nullopt);
    void browse(FilePurpose purpose);
    /// Shows the canvas to an audience, or goes back to work; either way, what is seen stays seen.
    void present(bool on);
    /// Closes the dialog without doing what it was for.
    void dismiss();

    // What the program answers.
    void opened(Document document, std::string path);
    /// Unsaved work of an earlier sitting, over the document as it is in the file of that path.
    void restored(Document work, std::string path, Document inFile);
    void wasSaved(std::string path);
    /// What a request asked for could not be done: says why, there too where the file was chosen.
    void failed(std::string why, std::optional<FileBrowser> chosenIn);
    void say(std::string text);
    void complain(std::string text);

    /// File name for people, "untitled" before the first save.
    std::string fileName() const;

    History history;
    View view;
    Gesture gesture;
    Studies studies;
    std::string path;
    std::optional<Dialog> dialog;
    std::optional<ContextMenu> contextMenu;
    std::vector<std::string> recentCommands; ///< ids of those run from the palette, latest first
    std::optional<Notice> notice;
    Log log;
    std::vector<Request> requests;
    std::vector<RecentFile> recent;       ///< the latest first
    std::vector<UnsavedWork> unsavedWork; ///< of editors that died, the latest first
    Keymap keymap;                        ///< the person's own shortcuts
    Habits habits;
    bool systemDialogsFound = false; ///< whether there is a program that shows them
    unsigned sitting = 0;            ///< rises whenever another document is begun
    double scale = 1;                ///< pixels per design pixel
    ScreenRect canvas;               ///< where the canvas was drawn last
    ScreenPoint pointer;             ///< where the pointer is
    bool pointerOnCanvas = false;
    std::optional<HeldKey> heldKey; ///< the key that was struck last, while it is down

  private:
    /// Where curves were put in another order, selection and active curve go along.
    void followOrder(const Document& before);
    /// After a step through the history: what it brought back is selected, and no number that
    /// stands for another point now.
    void followStep(const Document& before);
    /// Brings selection, active curve, cursor and studies back into what the document has.
    void tidy();
    /// Puts the cursor where it shows most: within the middle piece, at the lecture's u = 0.6.
    void restCursor();

    Document saved_;
    std::optional<Departure> afterSave_;
};

} // namespace splineloft::ui
