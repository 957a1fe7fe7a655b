#include "app/storage/places.h"

#include <cstdlib>
#include <string>

#include <sys/stat.h>

namespace splineloft::app {
namespace {

namespace fs = std::filesystem;

fs::path absoluteFrom(const char* variable) {
    const char* const value = std::getenv(variable);
    const fs::path path(value != nullptr ? value : "");
    return path.is_absolute() ? path : fs::path(); // relative ones are to be ignored
}

fs::path folderIn(const char* variable, const char* below) {
    auto base = absoluteFrom(variable);
    if (const auto home = absoluteFrom("HOME"); base.empty() && !home.empty()) {
        base = home / below;
    }
    return base.empty() ? base : base / "splineloft";
}

} // namespace

Places placesFromEnvironment() {
    return {folderIn("XDG_CONFIG_HOME", ".config"), folderIn("XDG_STATE_HOME", ".local/state")};
}

Result<Done> makeFolder(const fs::path& folder) {
    std::error_code error;
    if (fs::is_directory(folder, error)) {
        return Done{};
    }
    fs::create_directories(folder.parent_path(), error);
    if (!error && ::mkdir(folder.c_str(), S_IRWXU) != 0 && errno != EEXIST) {
        error = {errno, std::generic_category()};
    }
    return error ? Result<Done>(Refusal{folder.string(), "", "cannot be made: " + error.message(),
                                        "a folder that can be written to"})
                 : Done{};
}

} // namespace splineloft::app
