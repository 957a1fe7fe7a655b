#include "app/storage/system_dialog.h"

#include <array>
#include <cerrno>
#include <cstdlib>
#include <string_view>
#include <utility>

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;

namespace splineloft::app {
namespace {

namespace fs = std::filesystem;

std::string_view variable(const char* name) {
    const char* const value = std::getenv(name);
    return value != nullptr ? value : "";
}

std::optional<fs::path> onPath(const std::string& name) {
    std::string_view folders = variable("PATH");
    while (!folders.empty()) {
        const auto colon = folders.find(':');
        const fs::path candidate = fs::path(folders.substr(0, colon)) / name;
        if (candidate.is_absolute() && ::access(candidate.c_str(), X_OK) == 0) {
            return candidate;
        }
        folders = colon == folders.npos ? "" : folders.substr(colon + 1);
    }
    return std::nullopt;
}

/// Programs end with 1 for Cancel, and zenity also where it cannot show anything at all; but then
/// it is sooner over than any hand could be.
constexpr double fastestHand = 0.25; // seconds

SystemDialog::End meaningOf(int status, const std::string& heard, double seconds) {
    constexpr int accepted = 0;
    constexpr int cancelled = 1;
    if (!WIFEXITED(status)) {
        return SystemDialog::End::failed;
    }
    if (WEXITSTATUS(status) == cancelled) {
        return seconds < fastestHand ? SystemDialog::End::failed : SystemDialog::End::cancelled;
    }
    return WEXITSTATUS(status) == accepted && !heard.empty() ? SystemDialog::End::chosen
                                                             : SystemDialog::End::failed;
}

/// Starts a program whose output goes into a pipe; the reading end, or -1.
int start(const std::vector<std::string>& command, int& process) {
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) {
        return -1;
    }
    ::fcntl(ends[0], F_SETFL, O_NONBLOCK);
    std::vector<char*> words;
    for (const auto& word : command) {
        words.push_back(const_cast<char*>(word.c_str())); // posix_spawn does not write to it
    }
    words.push_back(nullptr);
    posix_spawn_file_actions_t actions{};
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    // Signals that this program waits for would otherwise mean nothing to that one.
    sigset_t none{};
    sigemptyset(&none);
    posix_spawnattr_t attributes{};
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setsigmask(&attributes, &none);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK);
    const int error =
        ::posix_spawn(&process, words.front(), &actions, &attributes, words.data(), environ);
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&actions);
    ::close(ends[1]);
    if (error != 0) {
        ::close(ends[0]);
        process = 0;
        return -1;
    }
    return ends[0];
}

} // namespace

std::optional<fs::path> systemDialogProgram() {
    const bool hasDisplay = !variable("DISPLAY").empty() || !variable("WAYLAND_DISPLAY").empty();
    if (!hasDisplay || variable("SPLINELOFT_DIALOG") == "own") {
        return std::nullopt;
    }
    const bool kde = variable("XDG_CURRENT_DESKTOP").find("KDE") != std::string_view::npos;
    const auto first = onPath(kde ? "kdialog" : "zenity");
    return first ? first : onPath(kde ? "zenity" : "kdialog");
}

std::vector<std::string> systemDialogCommand(const fs::path& program,
                                             const ui::FileBrowser& browser) {
    const bool opens = browser.purpose == ui::FilePurpose::open;
    const std::string title = opens ? "Open" : "Save as";
    const auto start = (browser.folder / browser.name).string();
    if (program.filename() == "kdialog") {
        return {program.string(),
                "--title",
                title,
                opens ? "--getopenfilename" : "--getsavefilename",
                start,
                "Splineloft documents (*.json)"};
    }
    std::vector<std::string> command = {program.string(),
                                        "--file-selection",
                                        "--title=" + title,
                                        "--filename=" + start,
                                        "--file-filter=Splineloft documents | *.json",
                                        "--file-filter=All files | *"};
    if (!opens) {
        command.insert(command.end(), {"--save", "--confirm-overwrite"});
    }
    return command;
}

void SystemDialog::ask(const fs::path& program, ui::FileBrowser browser) {
    close();
    browser_ = std::move(browser);
    heard_.clear();
    asked_ = Clock::now();
    pipe_ = start(systemDialogCommand(program, browser_), process_);
    startFailed_ = pipe_ < 0;
}

void SystemDialog::listen() {
    std::array<char, 4096> block{};
    for (ssize_t count = 1; count > 0 || (count < 0 && errno == EINTR);) {
        count = ::read(pipe_, block.data(), block.size());
        heard_.append(block.data(), count > 0 ? static_cast<std::size_t>(count) : 0);
    }
}

std::optional<SystemDialog::Answer> SystemDialog::answer() {
    if (std::exchange(startFailed_, false)) {
        return Answer{End::failed, std::move(browser_), {}};
    }
    int status = 0;
    if (!asking()) {
        return std::nullopt;
    }
    listen();
    if (::waitpid(process_, &status, WNOHANG) != process_) {
        return std::nullopt;
    }
    process_ = 0;
    listen(); // its last words
    close();
    if (heard_.ends_with('\n')) {
        heard_.pop_back();
    }
    const double seconds = Seconds(Clock::now() - asked_).count();
    return Answer{meaningOf(status, heard_, seconds), std::move(browser_), heard_};
}

void SystemDialog::close() {
    if (process_ != 0) {
        ::kill(process_, SIGKILL);
        ::waitpid(process_, nullptr, 0);
        process_ = 0;
    }
    if (pipe_ >= 0) {
        ::close(std::exchange(pipe_, -1));
    }
}

} // namespace splineloft::app
