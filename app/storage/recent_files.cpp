#include "app/storage/recent_files.h"

#include "app/storage/file_lock.h"
#include "app/storage/places.h"
#include "core/formats/file.h"
#include "core/formats/json_tape.h"
#include "core/formats/json_text.h"

#include <algorithm>
#include <chrono>
#include <thread>

namespace splineloft::app {
namespace {

namespace fs = std::filesystem;

/// Holds the list while it is changed. Another editor does so for a moment only; one that was
/// stopped in that moment is not waited for.
std::optional<FileLock> lockOf(const fs::path& list) {
    constexpr int mostTries = 100;
    constexpr std::chrono::milliseconds pause(5);
    auto name = list;
    name.replace_extension(".lock");
    auto lock = FileLock::of(name);
    for (int tries = 1; !lock && tries < mostTries; ++tries) {
        std::this_thread::sleep_for(pause);
        lock = FileLock::of(name);
    }
    return lock;
}

/// The paths in the list; none where it is damaged, which is no great loss.
std::vector<std::string> pathsIn(const fs::path& list) {
    std::vector<std::string> paths;
    const auto text = readFile(list);
    const auto tape = text ? readJson(*text) : Result<JsonTape>(text.refusal());
    if (tape && tape->root().kind() == JsonKind::array) {
        forEachEntry(tape->root(), [&](const JsonValue& entry) {
            if (entry.kind() == JsonKind::text && paths.size() < mostRecentFiles) {
                paths.emplace_back(entry.text());
            }
        });
    }
    return paths;
}

Result<Done> write(const fs::path& list, const std::vector<std::string>& paths) {
    JsonText text;
    text.beginArray();
    for (const auto& path : paths) {
        text.text(path);
    }
    text.end();
    return saveFile(list, std::move(text).finished());
}

} // namespace

std::vector<ui::RecentFile> readRecent(const fs::path& list) {
    std::vector<ui::RecentFile> files;
    for (auto& path : pathsIn(list)) {
        std::error_code failed;
        const bool isThere = fs::is_regular_file(path, failed);
        files.push_back({std::move(path), isThere});
    }
    return files;
}

Result<Done> noteRecent(const fs::path& list, const std::string& path) {
    if (auto made = makeFolder(list.parent_path()); !made) {
        return made;
    }
    const auto lock = lockOf(list);
    auto paths = pathsIn(list);
    std::erase(paths, path);
    paths.insert(paths.begin(), path);
    paths.resize(std::min(paths.size(), mostRecentFiles));
    return write(list, paths);
}

Result<Done> clearRecent(const fs::path& list) {
    const auto lock = lockOf(list);
    return write(list, {});
}

} // namespace splineloft::app
