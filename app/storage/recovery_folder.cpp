#include "app/storage/recovery_folder.h"

#include "app/storage/places.h"
#include "core/formats/document_json.h"
#include "core/formats/file.h"
#include "core/formats/json_tape.h"
#include "core/formats/json_text.h"

#include <algorithm>
#include <atomic>
#include <chrono>

#include <sys/stat.h>
#include <unistd.h>

namespace splineloft::app {
namespace {

namespace fs = std::filesystem;

constexpr int mostTries = 5; // to get a lock that is ours by right

std::string newId() {
    static std::atomic<unsigned> count = 0;
    const auto now = std::chrono::system_clock::now().time_since_epoch();
    return std::to_string(now / std::chrono::microseconds(1)) + "-" + std::to_string(::getpid()) +
           "-" + std::to_string(count++);
}

std::string headerFor(const std::string& path) {
    JsonText text;
    text.beginObject();
    text.key("path");
    text.text(path);
    text.key("process");
    text.count(static_cast<std::size_t>(::getpid()));
    text.end();
    return std::move(text).finished();
}

/// The path in a lock file; empty where an editor died before it had written it.
std::string pathIn(const std::string& header) {
    const auto tape = readJson(header);
    const auto path = tape ? memberOf(tape->root(), "path") : std::nullopt;
    return path && path->kind() == JsonKind::text ? std::string(path->text()) : "";
}

ui::WallTime timeOf(const fs::path& file) {
    struct stat status{};
    return ::stat(file.c_str(), &status) == 0
               ? std::chrono::system_clock::from_time_t(status.st_mtime)
               : ui::WallTime();
}

std::vector<std::string> idsIn(const fs::path& folder, std::string_view ending) {
    std::vector<std::string> ids;
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
         entry.increment(error)) {
        if (entry->path().extension() == ending) {
            ids.push_back(entry->path().stem().string());
        }
    }
    return ids;
}

ui::UnsavedWork offerOf(const RecoverySlot& slot, const Document& document) {
    ui::UnsavedWork offer{slot.id(),
                          slot.path(),
                          timeOf(slot.document()),
                          document.curves.size(),
                          0,
                          ui::thumbnailOf(document)};
    for (const auto& curve : document.curves) {
        offer.points += curve->points.size();
    }
    return offer;
}

bool isInItsFile(const RecoverySlot& slot, const std::string& text) {
    const auto saved = readFile(slot.path());
    return !slot.path().empty() && saved && *saved == text;
}

std::optional<FoundWork> lookInto(std::shared_ptr<RecoverySlot> slot,
                                  std::vector<std::string>& problems) {
    std::error_code failed;
    if (!fs::exists(slot->document(), failed)) {
        slot->remove(); // its editor was about to end well
        return std::nullopt;
    }
    const auto text = readFile(slot->document());
    if (text && isInItsFile(*slot, *text)) {
        slot->remove(); // it was saved in the editor's last moment
        return std::nullopt;
    }
    auto document = text ? readDocument(*text) : Result<Document>(text.refusal());
    if (!document) {
        const auto aside = slot->document().string() + ".bad";
        std::error_code ignored;
        fs::rename(slot->document(), aside, ignored);
        slot->remove();
        problems.push_back("Unsaved work cannot be read; it is put aside as " + aside + ": " +
                           document.refusal().message());
        return std::nullopt;
    }
    auto offer = offerOf(*slot, *document);
    return FoundWork{std::move(slot), std::move(*document), std::move(offer)};
}

} // namespace

RecoverySlot::RecoverySlot(fs::path folder, const std::string& path)
    : folder_(std::move(folder)), id_(newId()) {
    std::error_code failed;
    path_ = path.empty() ? "" : fs::absolute(path, failed).string();
}

std::shared_ptr<RecoverySlot> RecoverySlot::claim(const fs::path& folder, const std::string& id) {
    auto slot = std::make_shared<RecoverySlot>(folder, "");
    slot->id_ = id;
    slot->lock_ = FileLock::of(slot->lockFile());
    if (!slot->lock_) {
        return nullptr;
    }
    slot->path_ = pathIn(slot->lock_->text());
    return slot;
}

Result<Done> RecoverySlot::takeLock() {
    if (lock_) {
        return Done{};
    }
    if (auto made = makeFolder(folder_); !made) {
        return made;
    }
    auto lock = FileLock::of(lockFile());
    for (int tries = 1; !lock && tries < mostTries; ++tries) {
        lock = FileLock::of(lockFile()); // another editor was looking into it
    }
    if (!lock || !lock->write(headerFor(path_))) {
        std::error_code ignored;
        fs::remove(lockFile(), ignored);
        return Refusal{lockFile().string(), "", "cannot be written",
                       "a folder that can be written to, with space left"};
    }
    lock_ = std::move(lock);
    return Done{};
}

Result<Done> RecoverySlot::keep(const Document& document) {
    // First the lock: a document without one would be taken for a dead editor's.
    if (auto locked = takeLock(); !locked) {
        return locked;
    }
    return saveFile(this->document(), writeDocument(document));
}

void RecoverySlot::remove() {
    std::error_code ignored;
    // The lock goes last, for the reason above.
    fs::remove(document(), ignored);
    if (lock_) {
        fs::remove(lockFile(), ignored);
        lock_.reset();
    }
}

std::vector<FoundWork> findUnsavedWork(const fs::path& folder, std::vector<std::string>& problems) {
    std::vector<FoundWork> found;
    sweepStaleTemporaries(folder);
    for (const auto& id : idsIn(folder, ".json")) {
        if (auto slot = RecoverySlot::claim(folder, id)) {
            if (auto work = lookInto(std::move(slot), problems)) {
                found.push_back(std::move(*work));
            }
        }
    }
    for (const auto& id : idsIn(folder, ".lock")) {
        const auto slot = RecoverySlot::claim(folder, id);
        std::error_code ignored;
        if (slot && !fs::exists(slot->document(), ignored)) {
            slot->remove();
        }
    }
    std::ranges::sort(found, [](const FoundWork& a, const FoundWork& b) {
        return std::pair(b.offer.time, b.offer.id) < std::pair(a.offer.time, a.offer.id);
    });
    return found;
}

} // namespace splineloft::app
