// The system's own dialog for choosing a file: zenity or kdialog, run beside the editor, which goes
// on meanwhile.
#pragma once

#include "app/moment.h"
#include "ui/session.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace splineloft::app {

/// The program that shows such dialogs here; nothing where there is none on the PATH, no display,
/// or SPLINELOFT_DIALOG=own.
std::optional<std::filesystem::path> systemDialogProgram();

/// How it is called to do what a browser would.
std::vector<std::string> systemDialogCommand(const std::filesystem::path& program,
                                             const ui::FileBrowser& browser);

class SystemDialog {
  public:
    enum class End { chosen, cancelled, failed };
    struct Answer {
        End end;
        ui::FileBrowser browser; ///< that was asked for
        std::filesystem::path path;
    };

    SystemDialog() = default;
    SystemDialog(const SystemDialog&) = delete;
    SystemDialog& operator=(const SystemDialog&) = delete;
    ~SystemDialog() { close(); }

    /// Shows the dialog, in place of any that is shown already.
    void ask(const std::filesystem::path& program, ui::FileBrowser browser);
    bool asking() const { return process_ != 0; }
    /// What came of it, once, as soon as that is known. Never waits.
    std::optional<Answer> answer();
    void close();

  private:
    void listen();

    int process_ = 0;
    Moment asked_;
    int pipe_ = -1;
    ui::FileBrowser browser_;
    std::string heard_;
    bool startFailed_ = false;
};

} // namespace splineloft::app
