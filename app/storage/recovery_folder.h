// Unsaved work on the disk. Each piece is two files: ID.json is the document just as a save would
// write it, and ID.lock says which file it belongs to. The editor that works on it holds the lock;
// where nobody does, that editor has died.
#pragma once

#include "app/storage/file_lock.h"
#include "core/document/document.h"
#include "core/formats/result.h"
#include "ui/recovery.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace splineloft::app {

/// A place for one document's unsaved work. Only one thread at a time may use it.
class RecoverySlot {
  public:
    /// A new one, of which nothing is on the disk yet. `path` is the document's file, or empty.
    RecoverySlot(std::filesystem::path folder, const std::string& path);
    /// The one that is on the disk under that id; nothing where an editor still works on it.
    static std::shared_ptr<RecoverySlot> claim(const std::filesystem::path& folder,
                                               const std::string& id);

    /// Puts the document on the disk in place of what was kept before.
    Result<Done> keep(const Document& document);
    /// Takes both files away.
    void remove();

    const std::string& id() const { return id_; }
    const std::string& path() const { return path_; }
    std::filesystem::path document() const { return folder_ / (id_ + ".json"); }
    std::filesystem::path lockFile() const { return folder_ / (id_ + ".lock"); }

  private:
    Result<Done> takeLock();

    std::filesystem::path folder_;
    std::string id_, path_;
    std::optional<FileLock> lock_;
};

/// Work that was found, and the right to it.
struct FoundWork {
    std::shared_ptr<RecoverySlot> slot;
    Document document;
    ui::UnsavedWork offer;
};

/// All work in a folder on which no editor works, the latest first; it stays claimed as long as
/// the slots live. Sweeps away what dead editors left that is of no use: halves of files, locks
/// without a document, documents that are in their files after all. What cannot be read is put
/// aside under the ending .bad and told in `problems`.
std::vector<FoundWork> findUnsavedWork(const std::filesystem::path& folder,
                                       std::vector<std::string>& problems);

} // namespace splineloft::app
