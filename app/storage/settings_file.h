// The settings of a session, kept in a file from one start to the next.
#pragma once

#include "app/moment.h"
#include "app/storage/writer.h"
#include "ui/session.h"

#include <filesystem>
#include <optional>
#include <string>

namespace splineloft::app {

/// Watches one session and writes its settings once they have come to rest.
class SettingsFile {
  public:
    /// Where the settings are; empty: nowhere.
    explicit SettingsFile(std::filesystem::path file) : file_(std::move(file)) {}

    /// Gives the session what is in the file. A damaged file is put aside under the ending .bad.
    void read(ui::Session& session);

    /// Takes note of the settings now, and begins to write them where that is due.
    void look(const ui::Session& session, Moment now);
    /// Seconds until `look` has something to do although nothing has changed.
    double patience(Moment now) const;
    /// Writes at once what has changed, and waits until it is on the disk.
    void finish(const ui::Session& session);

    /// What went wrong with the disk, once.
    std::optional<std::string> takeComplaint() { return std::exchange(complaint_, std::nullopt); }

  private:
    void collect();
    void write();

    std::filesystem::path file_;
    std::string seen_, written_;
    std::optional<Moment> changed_;
    std::optional<std::string> complaint_;
    Writer writer_;
};

} // namespace splineloft::app
