// The table of all commands, and what it is asked.
#include "ui/commands/menus.h"

#include <algorithm>
#include <stdexcept>

namespace splineloft::ui {
namespace {

std::vector<Command> allCommands() {
    std::vector<Command> all;
    addFileCommands(all);
    addEditCommands(all);
    addViewCommands(all);
    addPointCommands(all);
    addCurveCommands(all);
    addMotionCommands(all);
    return all;
}

} // namespace

bool handsOff(const Session& session) {
    return !session.history.previewing();
}

bool hasCurve(const Session& session) {
    return session.active() != nullptr && handsOff(session);
}

bool canEditCurve(const Session& session) {
    return hasCurve(session) &&
           session.document().curves[session.view.activeCurve].look.isTouchable();
}

bool hasPieces(const Session& session) {
    return hasCurve(session) && !session.active()->pieces().empty();
}

bool hasSelection(const Session& session) {
    return !session.view.selection.empty() && handsOff(session);
}

std::vector<PointId> selected(const Session& session) {
    return session.view.selection.ids();
}

std::span<const Command> commands() {
    static const auto all = allCommands();
    return all;
}

const Command& commandNamed(std::string_view id) {
    const auto found = std::ranges::find(commands(), id, &Command::id);
    if (found == commands().end()) {
        throw std::out_of_range("there is no command " + std::string(id));
    }
    return *found;
}

std::span<const Shortcut> shortcutsOf(const Session& session, const Command& command) {
    const auto given = session.keymap.find(command.id);
    return given != session.keymap.end() ? given->second : command.shortcuts;
}

std::string shortcutName(const Session& session, const Command& command) {
    const auto shortcuts = shortcutsOf(session, command);
    return shortcuts.empty() ? "" : nameOf(shortcuts.front());
}

static bool isShortcutOf(const Session& session, const Shortcut& shortcut, const Command& command) {
    const auto all = shortcutsOf(session, command);
    return std::ranges::find(all, shortcut) != all.end();
}

bool hasCommand(const Session& session, const Shortcut& shortcut) {
    return std::ranges::any_of(commands(), [&](const Command& command) {
        return isShortcutOf(session, shortcut, command) && command.possible(session);
    });
}

bool runShortcut(Session& session, const Shortcut& shortcut, Strike strike) {
    for (const auto& command : commands()) {
        const bool due = command.onTap ? strike == Strike::tap
                                       : strike == Strike::fresh ||
                                             (strike == Strike::repeated && command.repeats);
        if (due && isShortcutOf(session, shortcut, command) && command.possible(session)) {
            command.run(session);
            return true;
        }
    }
    return false;
}

} // namespace splineloft::ui
