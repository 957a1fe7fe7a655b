#include "ui/command_search.h"

#include "ui/fuzzy.h"

#include <algorithm>
#include <functional>
#include <utility>

namespace splineloft::ui {
namespace {

std::string titleOf(const Command& command, const Session& session) {
    return (command.menu.empty() ? "" : command.menu + ": ") + command.name(session);
}

/// Higher is better: how well it matches, or how lately it was run.
double scoreOf(const Command& command, const Session& session, const FuzzyMatch& match,
               bool anythingTyped) {
    if (anythingTyped) {
        return match.score;
    }
    const auto& recent = session.recentCommands;
    const auto found = std::ranges::find(recent, command.id);
    return static_cast<double>(recent.end() - found);
}

} // namespace

std::vector<FoundCommand> findCommands(const Session& session, std::string_view typed) {
    const bool anything = typed.find_first_not_of(' ') != std::string_view::npos;
    std::vector<std::pair<double, FoundCommand>> found;
    for (const auto& command : commands()) {
        auto title = titleOf(command, session);
        if (auto match = fuzzyMatch(typed, title)) {
            const double score = scoreOf(command, session, *match, anything);
            found.push_back(
                {score, FoundCommand{&command, std::move(title), std::move(match->letters)}});
        }
    }
    std::ranges::stable_sort(found, std::greater(), &std::pair<double, FoundCommand>::first);
    std::vector<FoundCommand> sorted;
    for (auto& [score, command] : found) {
        sorted.push_back(std::move(command));
    }
    return sorted;
}

} // namespace splineloft::ui
