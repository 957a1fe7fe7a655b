// Finding a command by a few letters of its name.
#pragma once

#include "ui/commands.h"

#include <string>
#include <string_view>
#include <vector>

namespace splineloft::ui {

/// A command that was found.
struct FoundCommand {
    const Command* command = nullptr;
    std::string title;                ///< its menu and its name
    std::vector<std::size_t> letters; ///< bytes of the title at which matched letters begin
};

/// Commands whose menu and name match what was typed, the best first. All of them where nothing was
/// typed: those found here before first, the latest of them at the top.
std::vector<FoundCommand> findCommands(const Session& session, std::string_view typed);

} // namespace splineloft::ui
