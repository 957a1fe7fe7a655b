// The in-app file browser: the same everywhere, with no other program needed.
#pragma once

#include "ui/session.h"
#include "ui/stage.h"

#include <optional>

namespace splineloft::ui {

/// Draws the inside of the browser; answers with the request once a file was chosen.
std::optional<Request> drawBrowser(FileBrowser& browser, const Stage& window);

} // namespace splineloft::ui
