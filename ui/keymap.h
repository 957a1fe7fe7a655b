// The shortcuts file: {"command id": ["Ctrl+Shift+S", ...], ...}.
#pragma once

#include "ui/commands.h"

#include <string>
#include <string_view>
#include <vector>

namespace splineloft::ui {

/// A keymap as far as a file made sense, and what did not, in words.
struct KeymapFound {
    Keymap keymap;
    std::vector<std::string> problems;
};

/// Reads the text of a shortcuts file. What it says of a command replaces all that the command has
/// by itself. Where two commands want one shortcut, the earlier of two in the file has it, and any
/// in the file before one that has it by itself.
KeymapFound keymapFrom(std::string_view text);

/// The text of a file with the shortcuts that all commands have in a session.
std::string keymapText(const Session& session);

} // namespace splineloft::ui
