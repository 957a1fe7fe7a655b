// The in-app file browser: the same everywhere, with no other program needed.
#pragma once

#include "ui/session.h"
#include "ui/stage.h"

#include <optional>
#include <span>

namespace splineloft::ui {

/// Draws the inside of the browser, for opening with the files of late above the folder's; answers
/// with the request once a file was chosen.
std::optional<Request> drawBrowser(FileBrowser& browser, std::span<const RecentFile> recent,
                                   const Stage& window);

} // namespace splineloft::ui
