// One sitting at the editor: the document with its history, the way it is looked at, and what has
// been asked of the program around it. Edits come in through one door, `apply`.
#pragma once

#include "core/document/history.h"
#include "ui/canvas/gesture.h"
#include "ui/edit.h"
#include "ui/study.h"

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace splineloft::ui {

// --- what the program around the interface is asked to do
// --------------------------------------------

struct OpenFile {
    std::string path;
};
struct SaveFile {
    std::string path;
};
/// Writes samples of the active curve, as JSON or CSV by the ending of the path.
struct ExportSamples {
    std::string path;
    Even even = Even::length;
    int count = 100;
};
struct Quit {};

using Request = std::variant<OpenFile, SaveFile, ExportSamples, Quit>;

// --- what leaves the present document behind
// -----------------------------------------------------------

struct StartNew {};
/// Opens a file; asks which where the path is empty.
struct GoToFile {
    std::string path;
};
using Departure = std::variant<StartNew, GoToFile, Quit>;

// --- what stands in front of everything else
// ------------------------------------------------------------

enum class FilePurpose { open, save, exportSamples };

/// The in-app file browser.
struct FileBrowser {
    FilePurpose purpose = FilePurpose::open;
    std::filesystem::path folder;
    std::string name;
    Even even = Even::length;
    int count = 100;
    bool overwriteAsked = false;
    bool closed = false; ///< the person has had enough of it
};
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
using Dialog = std::variant<FileBrowser, UnsavedQuestion, KeyList, Palette>;

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
    void wasSaved(std::string path);
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
    std::vector<Request> requests;
    double scale = 1;    ///< pixels per design pixel
    ScreenRect canvas;   ///< where the canvas was drawn last
    ScreenPoint pointer; ///< where the pointer is
    bool pointerOnCanvas = false;
    std::optional<HeldKey> heldKey; ///< the key that was struck last, while it is down

  private:
    /// Brings selection, active curve, cursor and studies back into what the document has.
    void tidy();
    /// Puts the cursor where it shows most: within the middle piece, at the lecture's u = 0.6.
    void restCursor();

    Document saved_;
    std::optional<Departure> afterSave_;
};

} // namespace splineloft::ui
