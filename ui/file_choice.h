// From a name that was chosen, in our own browser or in the system's dialog, to what is to be done
// with that file.
#pragma once

#include "ui/session.h"

#include <filesystem>
#include <optional>
#include <string>

namespace splineloft::ui {

/// The chosen file, with the ending that its purpose needs.
std::filesystem::path chosenPath(const FileBrowser& browser);

/// What to do with the chosen file. Nothing where it is a folder, which is entered, or where it
/// would be replaced and nobody was asked: then the browser asks from now on.
std::optional<Request> accept(FileBrowser& browser);

/// Takes a file that was chosen in the system's dialog in place of `browser`. The browser appears
/// where there is still something to be asked.
void acceptFromSystem(Session& session, FileBrowser browser, const std::filesystem::path& path);

/// "name — folder", for lists of files from everywhere.
std::string nameWithFolder(const std::string& path);

} // namespace splineloft::ui
