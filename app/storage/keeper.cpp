#include "app/storage/keeper.h"

#include "app/command_line/commands.h"
#include "app/files.h"
#include "app/storage/recent_files.h"
#include "core/formats/file.h"
#include "ui/file_choice.h"
#include "ui/keymap.h"

#include <algorithm>
#include <iostream>
#include <utility>

namespace splineloft::app {
namespace {

namespace fs = std::filesystem;

fs::path in(const fs::path& folder, const char* name) {
    return folder.empty() ? folder : folder / name;
}

constexpr auto settingsName = "settings.json";
constexpr auto shortcutsName = "shortcuts.json";
constexpr auto recentName = "recent.json";
constexpr auto recoveryName = "recovery";

constexpr double askDialogAgain = 0.05; // seconds

/// The document in a file, or an empty one where that cannot be read.
Document documentIn(const std::string& path) {
    auto document = path.empty() ? Result<Document>(Document{}) : openDocument(path, std::cin);
    return document ? std::move(*document) : Document{};
}

} // namespace

Keeper::Keeper(Places places, AutosavePace pace, const EndSignal* ending)
    : places_(std::move(places)), ending_(ending), settings_(in(places_.config, settingsName)),
      autosave_(in(places_.state, recoveryName), pace) {}

void Keeper::begin(ui::Session& session, const std::vector<std::string>& opened) {
    if (places_.config.empty() || places_.state.empty()) {
        session.complain("Settings and unsaved work are not kept: the environment names no folder "
                         "for them; right would be: HOME");
    }
    for (const auto& folder : {places_.config, places_.state}) {
        if (!folder.empty()) {
            sweepStaleTemporaries(folder);
        }
    }
    settings_.read(session);
    readShortcuts(session);
    session.systemDialogsFound = systemDialogProgram().has_value();
    session.recent = readRecent(in(places_.state, recentName));
    for (const auto& path : opened) {
        std::error_code failed;
        if (fs::exists(path, failed)) {
            noteRecent(session, path);
        }
    }
    offerUnsavedWork(session);
}

void Keeper::offerUnsavedWork(ui::Session& session) {
    if (places_.state.empty()) {
        return;
    }
    std::vector<std::string> problems;
    found_ = findUnsavedWork(in(places_.state, recoveryName), problems);
    for (const auto& problem : problems) {
        session.complain(problem);
    }
    for (const auto& work : found_) {
        session.unsavedWork.push_back(work.offer);
    }
    if (!found_.empty()) {
        session.dialog = ui::RecoveryOffer{};
    }
}

void Keeper::readShortcuts(ui::Session& session) const {
    const auto file = in(places_.config, shortcutsName);
    std::error_code failed;
    if (file.empty() || !fs::exists(file, failed)) {
        session.keymap.clear();
        return;
    }
    const auto text = readFile(file);
    if (!text) {
        return session.complain(text.refusal().message());
    }
    auto [keymap, problems] = ui::keymapFrom(*text);
    session.keymap = std::move(keymap);
    for (const auto& problem : problems) {
        session.log.add(file.string() + ": " + problem, true);
    }
    if (!problems.empty()) {
        const auto more = problems.size() - 1;
        session.notice = ui::Notice{
            file.string() + ": " + problems.front() +
                (more > 0 ? " (and " + std::to_string(more) + " more: see View, Messages)" : ""),
            true};
    }
}

bool Keeper::afterFrame(ui::Session& session, const ui::Screen& screen) {
    if (!session.view.presenting) { // then it fills the monitor
        session.habits.windowWidth = screen.width / screen.scale;
        session.habits.windowHeight = screen.height / screen.scale;
    }
    const bool asked = !session.requests.empty();
    if (!carryOutRequests(session)) {
        return false;
    }
    if (mustEnd()) {
        autosave_.keepNow(session);
        finish(session);
        return false;
    }
    news_ = false; // this frame has shown what there was before
    news_ = attend(session) || asked;
    return true;
}

bool Keeper::attend(ui::Session& session) {
    const auto now = Clock::now();
    autosave_.look(session, now);
    settings_.look(session, now);
    bool news = std::exchange(news_, false) || mustEnd();
    news |= attendRecent(session);
    news |= attendDialog(session);
    for (const auto& complaint : {autosave_.takeComplaint(), settings_.takeComplaint()}) {
        if (complaint) {
            session.complain(*complaint);
            news = true;
        }
    }
    return news;
}

double Keeper::patience() const {
    const auto now = Clock::now();
    return news_ ? 0
                 : std::min({autosave_.patience(now), settings_.patience(now),
                             recentWriter_.busy() ? Writer::askAgain : never,
                             dialog_.asking() ? askDialogAgain : never});
}

bool Keeper::carryOutRequests(ui::Session& session) {
    for (const auto& request : std::exchange(session.requests, {})) {
        std::visit([&](const auto& asked) { carryOut(session, asked); }, request);
    }
    // A save may lead on to what it was for.
    return !ended_ && (session.requests.empty() || carryOutRequests(session));
}

// --- documents
// ------------------------------------------------------------------------------------

void Keeper::carryOut(ui::Session& session, const ui::OpenFiles& request) {
    const auto opened = openTogether(session, request);
    // The first, which gives the document its name, last: the top of the list.
    for (auto path = opened.rbegin(); path != opened.rend(); ++path) {
        noteRecent(session, *path);
    }
}

void Keeper::carryOut(ui::Session& session, const ui::SaveFile& request) {
    if (saveTo(session, request)) {
        noteRecent(session, request.path);
    }
}

void Keeper::carryOut(ui::Session& session, const ui::ExportSamples& request) {
    exportSamples(session, request);
}

void Keeper::carryOut(ui::Session& session, const ui::Quit&) {
    ended_ = true;
    autosave_.end();
    finish(session);
}

/// All that is to be on the disk at the end.
void Keeper::finish(ui::Session& session) {
    settings_.finish(session);
    while (!toNote_.empty()) {
        recentWriter_.wait();
        attendRecent(session);
    }
}

// --- files of late
// --------------------------------------------------------------------------------

void Keeper::noteRecent(ui::Session& session, const std::string& path) {
    std::error_code failed;
    const auto whole = fs::absolute(path, failed).lexically_normal().string();
    std::erase_if(session.recent, [&](const ui::RecentFile& f) { return f.path == whole; });
    session.recent.insert(session.recent.begin(), {whole, true});
    session.recent.resize(std::min(session.recent.size(), mostRecentFiles));
    if (!places_.state.empty()) {
        toNote_.push_back(whole);
    }
}

bool Keeper::attendRecent(ui::Session& session) {
    bool news = false;
    if (const auto outcome = recentWriter_.outcome(); outcome && !*outcome) {
        session.complain("The list of recent files cannot be kept: " +
                         outcome->refusal().message());
        toNote_.clear();
        places_.state.clear(); // said once
        news = true;
    }
    if (!toNote_.empty() && !recentWriter_.busy()) {
        recentWriter_.begin([list = in(places_.state, recentName), path = toNote_.front()] {
            return app::noteRecent(list, path);
        });
        toNote_.pop_front();
    }
    return news;
}

void Keeper::carryOut(ui::Session& session, const ui::LookForRecent&) {
    if (!places_.state.empty() && toNote_.empty() && !recentWriter_.busy()) {
        session.recent = readRecent(in(places_.state, recentName));
    }
}

void Keeper::carryOut(ui::Session& session, const ui::ForgetRecent&) {
    session.recent.clear();
    toNote_.clear();
    recentWriter_.wait();
    attendRecent(session);
    if (!places_.state.empty()) {
        recentWriter_.begin([list = in(places_.state, recentName)] { return clearRecent(list); });
    }
}

// --- unsaved work of editors that died
// -------------------------------------------------------------

std::optional<FoundWork> Keeper::take(ui::Session& session, const std::string& id) {
    std::erase_if(session.unsavedWork, [&](const ui::UnsavedWork& w) { return w.id == id; });
    const auto found = std::ranges::find(found_, id, [](const FoundWork& w) { return w.offer.id; });
    if (found == found_.end()) {
        return std::nullopt;
    }
    auto work = std::move(*found);
    found_.erase(found);
    return work;
}

void Keeper::carryOut(ui::Session& session, const ui::RestoreWork& request) {
    if (auto work = take(session, request.id)) {
        const auto& path = work->slot->path();
        session.restored(std::move(work->document), path, documentIn(path));
        autosave_.adopt(std::move(work->slot), session);
    }
}

void Keeper::carryOut(ui::Session& session, const ui::DiscardWork& request) {
    if (const auto work = take(session, request.id)) {
        work->slot->remove();
    }
}

// --- shortcuts
// ------------------------------------------------------------------------------------

void Keeper::carryOut(ui::Session& session, const ui::ReadShortcuts&) {
    session.say("The shortcuts were read again.");
    readShortcuts(session);
}

void Keeper::carryOut(ui::Session& session, const ui::MakeShortcutsFile&) {
    const auto file = in(places_.config, shortcutsName);
    std::error_code failed;
    if (file.empty()) {
        return session.complain("There is no folder for the shortcuts file; right would be: HOME");
    }
    if (!fs::exists(file, failed)) {
        auto done = makeFolder(places_.config);
        done = done ? saveFile(file, ui::keymapText(session)) : done;
        if (!done) {
            return session.complain(done.refusal().message());
        }
    }
    session.say("The shortcuts are in " + file.string() +
                ": change them there, then read them again from this menu.");
}

// --- the system's dialog
// --------------------------------------------------------------------------

void Keeper::carryOut(ui::Session& session, const ui::AskForFile& request) {
    if (const auto program = systemDialogProgram()) {
        dialog_.ask(*program, request.browser);
    } else {
        session.dialog = request.browser;
    }
}

bool Keeper::attendDialog(ui::Session& session) {
    auto answer = dialog_.answer();
    if (!answer) {
        return false;
    }
    switch (answer->end) {
    case SystemDialog::End::chosen:
        ui::acceptFromSystem(session, std::move(answer->browser), answer->path);
        break;
    case SystemDialog::End::cancelled: session.dismiss(); break;
    case SystemDialog::End::failed:
        session.systemDialogsFound = false; // not again in this sitting
        session.complain("The system's dialog does not work here; this is Splineloft's own.");
        session.dialog = std::move(answer->browser);
    }
    return true;
}

} // namespace splineloft::app
