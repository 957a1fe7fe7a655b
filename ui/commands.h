// Everything that can be asked for by name: one table, from which menus, shortcuts and the key list
// are drawn.
#pragma once

#include "ui/session.h"

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace splineloft::ui {

struct Command {
    std::string id;   ///< e.g. "file.save"
    std::string menu; ///< title of the menu it stands in; empty: in none
    std::function<std::string(const Session&)> name;
    /// By itself; `shortcutsOf` knows those that the session gives it instead.
    std::vector<Shortcut> shortcuts = {};
    std::function<void(Session&)> run = nullptr;
    std::function<bool(const Session&)> possible = [](const Session&) { return true; };
    /// For what is on or off.
    std::function<bool(const Session&)> checked = nullptr;
    bool startsGroup = false; ///< a line stands above it in the menu
    bool repeats = false;     ///< again and again while its key is held down
    bool onTap = false;       ///< when its key is let go, if nothing was done with it held down
    /// In which menus of the right button it stands.
    std::vector<Context> contexts = {};
    std::string submenu = {}; ///< under which title within its menu; empty: in the menu itself
};

std::span<const Command> commands();

/// The command of that id. Throws std::out_of_range where there is none.
const Command& commandNamed(std::string_view id);

/// The shortcuts that a command has in this session: its own, or those of the session's keymap.
std::span<const Shortcut> shortcutsOf(const Session& session, const Command& command);

/// The first of them as people write it; empty where it has none.
std::string shortcutName(const Session& session, const Command& command);

/// Whether a key was struck, is only still held down, or was let go with nothing done meanwhile.
enum class Strike { fresh, repeated, tap };

/// Whether a command that is possible now has that shortcut.
bool hasCommand(const Session& session, const Shortcut& shortcut);

/// Runs the possible command of that shortcut, if there is one.
bool runShortcut(Session& session, const Shortcut& shortcut, Strike strike = Strike::fresh);

} // namespace splineloft::ui
