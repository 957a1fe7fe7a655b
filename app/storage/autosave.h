// Keeps what is in no file yet where a crash cannot take it, soon after it was done.
#pragma once

#include "app/moment.h"
#include "app/storage/recovery_folder.h"
#include "app/storage/writer.h"
#include "ui/session.h"

#include <memory>
#include <optional>
#include <string>

namespace splineloft::app {

/// When unsaved changes are to be kept: whichever comes first.
struct AutosavePace {
    int changes = 20;
    double seconds = 20;
};

/// Watches one session. Disk work is done on a thread of its own; nothing here waits for it.
class Autosave {
  public:
    /// `folder` is where to keep the work; empty: nowhere.
    explicit Autosave(std::filesystem::path folder, AutosavePace pace = {})
        : folder_(std::move(folder)), pace_(pace) {}

    /// Takes note of what the session holds now, and begins to write where that is due. Call it
    /// after whatever may have changed the session, and when `patience` is over.
    void look(const ui::Session& session, Moment now);

    /// Seconds until `look` has something to do although nothing has changed.
    double patience(Moment now) const;

    /// Goes on in the place of work that the session has just restored.
    void adopt(std::shared_ptr<RecoverySlot> slot, const ui::Session& session);

    /// What went wrong with the disk, once.
    std::optional<std::string> takeComplaint() { return std::exchange(complaint_, std::nullopt); }

    /// The program has to end: keeps what is in no file yet, and returns when that is done.
    void keepNow(const ui::Session& session);

    /// The session has come to its end as the person wished: forgets what is kept.
    void end();

  private:
    void collect(Moment now);
    void forget();
    void write(const ui::Session& session);
    Moment due() const;

    std::filesystem::path folder_;
    AutosavePace pace_;
    Document seen_;
    unsigned sitting_ = 0;
    int changes_ = 0;                 ///< since the last that was handed to the disk
    std::optional<Moment> since_;     ///< when the first of them was made
    std::optional<Moment> notBefore_; ///< after a failure
    int failures_ = 0;                ///< in a row
    std::optional<std::string> complaint_;
    std::shared_ptr<RecoverySlot> slot_;
    Writer writer_; // last, so that it comes to rest first
};

} // namespace splineloft::app
