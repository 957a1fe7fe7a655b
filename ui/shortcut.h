// Keys with their modifiers, and how people write them.
#pragma once

#include "ui/input.h"

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace splineloft::ui {

/// A key with its modifiers.
struct Shortcut {
    Key key;
    Modifiers modifiers = {};
    bool operator==(const Shortcut&) const = default;
};

/// As people write it: "Ctrl+Shift+S". The sign that the key shows tells of Shift by itself where
/// it is a plus: "Ctrl++".
std::string nameOf(const Shortcut& shortcut);

/// What `nameOf` wrote, whatever the case of its letters; also "Left", "Right", "Up" and "Down" for
/// the arrows. Nothing where the text means no shortcut.
std::optional<Shortcut> shortcutFrom(std::string_view text);

/// Shortcuts in place of those that commands have by themselves, by the commands' ids.
using Keymap = std::map<std::string, std::vector<Shortcut>, std::less<>>;

} // namespace splineloft::ui
