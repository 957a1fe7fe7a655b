#include "app/storage/settings_file.h"

#include "app/storage/places.h"
#include "core/formats/file.h"
#include "ui/settings.h"

namespace splineloft::app {
namespace {

namespace fs = std::filesystem;

constexpr double calm = 1; // seconds without a change before it is written

} // namespace

void SettingsFile::read(ui::Session& session) {
    std::error_code failed;
    if (!file_.empty() && fs::exists(file_, failed)) {
        const auto text = readFile(file_);
        const auto done = text ? ui::applySettings(session, *text) : Result<Done>(text.refusal());
        if (!done) {
            auto refusal = done.refusal();
            refusal.file = file_.string();
            auto aside = file_;
            aside += ".bad";
            fs::rename(file_, aside, failed);
            session.complain("The settings cannot be used, the usual ones hold: " +
                             refusal.message());
            if (failed) {
                file_.clear(); // what cannot be put aside is not written over either
            }
        }
    }
    seen_ = written_ = ui::settingsText(session);
}

void SettingsFile::look(const ui::Session& session, Moment now) {
    collect();
    if (file_.empty()) {
        return;
    }
    if (auto text = ui::settingsText(session); text != seen_) {
        seen_ = std::move(text);
        changed_ = now;
    }
    if (changed_ && now >= after(*changed_, calm) && !writer_.busy()) {
        write();
    }
}

double SettingsFile::patience(Moment now) const {
    return writer_.busy() ? Writer::askAgain
           : changed_     ? secondsUntil(after(*changed_, calm), now)
                          : never;
}

void SettingsFile::finish(const ui::Session& session) {
    writer_.wait();
    collect();
    seen_ = ui::settingsText(session);
    if (!file_.empty() && seen_ != written_) {
        write();
        writer_.wait();
    }
}

void SettingsFile::collect() {
    const auto outcome = writer_.outcome();
    if (outcome && !*outcome) {
        complaint_ = "The settings cannot be kept: " + outcome->refusal().message();
        file_.clear(); // said once; no use in trying on
    }
}

void SettingsFile::write() {
    changed_.reset();
    if (seen_ == written_) {
        return; // changed, and changed back
    }
    written_ = seen_;
    writer_.begin([file = file_, text = seen_] {
        auto made = makeFolder(file.parent_path());
        return made ? saveFile(file, text) : made;
    });
}

} // namespace splineloft::app
