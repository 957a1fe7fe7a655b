// What menus of every kind have in common.
#pragma once

#include "ui/commands.h"

#include <array>

namespace splineloft::ui {

/// Titles of the menus, in the order of the menu bar.
inline constexpr std::array menuTitles = {"File",  "Edit",   "View",   "Points",
                                          "Curve", "Family", "Motion", "Help"};

/// One line of an open menu: runs the command when it is taken.
void drawMenuItem(Session& session, const Command& command);

} // namespace splineloft::ui
