#include "ui/keymap.h"

#include "core/formats/json_tape.h"
#include "core/formats/json_text.h"

#include <algorithm>

namespace splineloft::ui {
namespace {

bool isCommand(std::string_view id) {
    return std::ranges::find(commands(), id, &Command::id) != commands().end();
}

/// Whether both commands have the shortcut by themselves: then it means each in its own situation.
bool shareByThemselves(const Shortcut& shortcut, std::string_view a, std::string_view b) {
    const auto has = [&](std::string_view id) {
        const auto& own = commandNamed(id).shortcuts;
        return std::ranges::find(own, shortcut) != own.end();
    };
    return has(a) && has(b);
}

/// Shortcuts that are given away.
class Owners {
  public:
    /// Leaves of a command's wishes those that nobody has, and says who has the others.
    std::vector<Shortcut> grant(const std::string& id, const std::vector<Shortcut>& wishes,
                                std::vector<std::string>& problems) {
        std::vector<Shortcut> granted;
        for (const auto& wish : wishes) {
            const auto owner = std::ranges::find_if(owned_, [&](const Owned& owned) {
                return owned.shortcut == wish && owned.command != id &&
                       !shareByThemselves(wish, owned.command, id);
            });
            if (owner == owned_.end()) {
                owned_.push_back({wish, id});
                granted.push_back(wish);
            } else {
                problems.push_back(nameOf(wish) + " cannot be both " + owner->command + " and " +
                                   id + ": it is " + owner->command);
            }
        }
        return granted;
    }

  private:
    struct Owned {
        Shortcut shortcut;
        std::string command;
    };
    std::vector<Owned> owned_;
};

/// The shortcuts that one entry of the file asks for.
std::vector<Shortcut> wishesOf(const std::string& id, const JsonValue& value,
                               std::vector<std::string>& problems) {
    std::vector<Shortcut> wishes;
    const auto refuse = [&](const std::string& what) {
        problems.push_back(id + ": " + what + R"(; right would be: ["Ctrl+Shift+S"], or [])");
    };
    if (value.kind() != JsonKind::array) {
        refuse(std::string(describe(value.kind())));
        return wishes;
    }
    forEachEntry(value, [&](const JsonValue& entry) {
        if (entry.kind() != JsonKind::text) {
            refuse("one of its shortcuts " + std::string(describe(entry.kind())));
        } else if (const auto shortcut = shortcutFrom(entry.text())) {
            wishes.push_back(*shortcut);
        } else {
            refuse(inQuotes(entry.text()) + " is no shortcut");
        }
    });
    return wishes;
}

} // namespace

KeymapFound keymapFrom(std::string_view text) {
    KeymapFound found;
    const auto tape = readJson(text);
    if (!tape || tape->root().kind() != JsonKind::object) {
        found.problems.push_back(tape ? "is no object of commands and their shortcuts"
                                      : tape.refusal().message());
        return found;
    }
    Owners owners;
    forEachMember(tape->root(), [&](std::string_view key, const JsonValue& value) {
        const std::string id(key);
        if (!isCommand(id)) {
            found.problems.push_back("there is no command " + inQuotes(id));
        } else if (value.kind() == JsonKind::array) {
            found.keymap[id] =
                owners.grant(id, wishesOf(id, value, found.problems), found.problems);
        } else {
            wishesOf(id, value, found.problems); // says what is wrong
        }
    });
    for (const auto& command : commands()) {
        if (!found.keymap.contains(command.id)) {
            auto left = owners.grant(command.id, command.shortcuts, found.problems);
            if (left.size() < command.shortcuts.size()) {
                found.keymap[command.id] = std::move(left);
            }
        }
    }
    return found;
}

std::string keymapText(const Session& session) {
    JsonText text;
    text.beginObject();
    for (const auto& command : commands()) {
        std::vector<std::string> names;
        for (const auto& shortcut : shortcutsOf(session, command)) {
            names.push_back(nameOf(shortcut));
        }
        text.key(command.id);
        text.texts(names);
    }
    text.end();
    return std::move(text).finished();
}

} // namespace splineloft::ui
