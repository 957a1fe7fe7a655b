// Where the program keeps what is its own, after the XDG Base Directory Specification 0.8.
#pragma once

#include "core/formats/result.h"

#include <filesystem>

namespace splineloft::app {

/// Folders, which need not exist yet; empty where the environment names none.
struct Places {
    std::filesystem::path config; ///< settings and shortcuts
    std::filesystem::path state;  ///< recent files and unsaved work
};

/// XDG_CONFIG_HOME and XDG_STATE_HOME where they are absolute, otherwise below HOME.
Places placesFromEnvironment();

/// Makes a folder, for its owner alone, with those that it lies in.
Result<Done> makeFolder(const std::filesystem::path& folder);

} // namespace splineloft::app
