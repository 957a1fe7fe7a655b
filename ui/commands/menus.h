// What the menus' tables of commands have in common.
#pragma once

#include "ui/commands.h"

namespace splineloft::ui {

inline constexpr Modifiers controlKey{.control = true};
inline constexpr Modifiers shiftKey{.shift = true};
inline constexpr Modifiers controlShiftKeys{.shift = true, .control = true};

/// The name of a command that is always called the same.
inline auto called(std::string name) {
    return [name = std::move(name)](const Session&) { return name; };
}

/// Keys edit what is settled; while a hand shows what is not, they wait.
bool handsOff(const Session& session);
bool hasCurve(const Session& session);
/// Whether hands may touch the active curve.
bool canEditCurve(const Session& session);
bool hasPieces(const Session& session);
bool hasSelection(const Session& session);
std::vector<PointId> selected(const Session& session);

// Each menu's part of the table, in the order of the menu bar.
void addFileCommands(std::vector<Command>& all);
void addClipboardCommands(std::vector<Command>& all);
void addEditCommands(std::vector<Command>& all);
void addViewCommands(std::vector<Command>& all);
void addPointCommands(std::vector<Command>& all);
void addCurveCommands(std::vector<Command>& all);
void addMotionCommands(std::vector<Command>& all);

} // namespace splineloft::ui
