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

std::string nameOf(Key key) {
    const int code = static_cast<int>(key);
    if (code > ' ' && code < 128) {
        return key == Key::equal ? "+" : std::string(1, static_cast<char>(code));
    }
    switch (key) {
    case Key::space: return "Space";
    case Key::escape: return "Esc";
    case Key::enter: return "Enter";
    case Key::keypadEnter: return "Enter (keypad)";
    case Key::backspace: return "Backspace";
    case Key::del: return "Delete";
    case Key::home: return "Home";
    case Key::left: return "←";
    case Key::right: return "→";
    case Key::up: return "↑";
    case Key::down: return "↓";
    case Key::pageUp: return "Page Up";
    case Key::pageDown: return "Page Down";
    case Key::f1: return "F1";
    case Key::f2: return "F2";
    case Key::f11: return "F11";
    default: return "key " + std::to_string(code);
    }
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
    return {session.view.selection.begin(), session.view.selection.end()};
}

std::string nameOf(const Shortcut& shortcut) {
    return std::string(shortcut.modifiers.control ? "Ctrl+" : "") +
           (shortcut.modifiers.alt ? "Alt+" : "") +
           (shortcut.modifiers.shift && shortcut.key != Key::equal ? "Shift+" : "") +
           nameOf(shortcut.key);
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

bool runShortcut(Session& session, const Shortcut& shortcut, Strike strike) {
    for (const auto& command : commands()) {
        const bool named =
            std::ranges::find(command.shortcuts, shortcut) != command.shortcuts.end();
        const bool due = command.onTap ? strike == Strike::tap
                                       : strike == Strike::fresh ||
                                             (strike == Strike::repeated && command.repeats);
        if (named && due && command.possible(session)) {
            command.run(session);
            return true;
        }
    }
    return false;
}

} // namespace splineloft::ui
