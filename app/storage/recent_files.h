// The files that were opened or saved lately, in a list that all editors share.
#pragma once

#include "core/formats/result.h"
#include "ui/session.h"

#include <filesystem>
#include <string>
#include <vector>

namespace splineloft::app {

inline constexpr std::size_t mostRecentFiles = 12;

/// The list as it is on the disk now, the latest first, each file looked for.
std::vector<ui::RecentFile> readRecent(const std::filesystem::path& list);

/// Puts a file at the top of the list on the disk, whoever else has changed that meanwhile.
Result<Done> noteRecent(const std::filesystem::path& list, const std::string& path);

Result<Done> clearRecent(const std::filesystem::path& list);

} // namespace splineloft::app
