#include "ui/shortcut.h"

#include "core/formats/numbers.h"

#include <algorithm>
#include <array>

namespace splineloft::ui {
namespace {

struct KeyName {
    Key key;
    std::string_view name;
};

// Where a key stands twice, its first name is the one that is shown.
constexpr std::array keyNames = {
    KeyName{Key::space, "Space"},    KeyName{Key::escape, "Esc"},
    KeyName{Key::enter, "Enter"},    KeyName{Key::keypadEnter, "Enter (keypad)"},
    KeyName{Key::tab, "Tab"},        KeyName{Key::backspace, "Backspace"},
    KeyName{Key::insert, "Insert"},  KeyName{Key::del, "Delete"},
    KeyName{Key::left, "←"},         KeyName{Key::right, "→"},
    KeyName{Key::up, "↑"},           KeyName{Key::down, "↓"},
    KeyName{Key::left, "Left"},      KeyName{Key::right, "Right"},
    KeyName{Key::up, "Up"},          KeyName{Key::down, "Down"},
    KeyName{Key::pageUp, "Page Up"}, KeyName{Key::pageDown, "Page Down"},
    KeyName{Key::home, "Home"},      KeyName{Key::end, "End"}};

constexpr std::string_view plus = "+";
constexpr std::string_view otherKey = "key "; // and its code
constexpr std::string_view keypad = "Keypad ";
constexpr int functionKeys = 25;
constexpr int keypadDigits = 10;

constexpr int code(Key key) {
    return static_cast<int>(key);
}

/// Whether the key's code is the character that it shows. A plus is said otherwise.
bool showsItself(int code) {
    return code > ' ' && code <= '`' && code != plus.front();
}

bool isPlus(const Shortcut& shortcut) {
    return shortcut.key == Key::equal && shortcut.modifiers.shift;
}

std::string nameOf(Key key) {
    const auto known = std::ranges::find(keyNames, key, &KeyName::key);
    const int function = code(key) - code(Key::f1);
    const int digit = code(key) - code(Key::keypad0);
    if (known != keyNames.end()) {
        return std::string(known->name);
    }
    if (showsItself(code(key))) {
        return std::string(1, static_cast<char>(key));
    }
    if (function >= 0 && function < functionKeys) {
        return "F" + std::to_string(function + 1);
    }
    if (digit >= 0 && digit < keypadDigits) {
        return std::string(keypad) + std::to_string(digit);
    }
    return std::string(otherKey) + std::to_string(code(key));
}

char lower(char sign) {
    return sign >= 'A' && sign <= 'Z' ? static_cast<char>(sign - 'A' + 'a') : sign;
}

bool same(std::string_view a, std::string_view b) {
    return std::ranges::equal(a, b, {}, lower, lower);
}

/// Takes a beginning away, if the text has it and goes on.
bool take(std::string_view& text, std::string_view beginning) {
    const bool begins =
        text.size() > beginning.size() && same(text.substr(0, beginning.size()), beginning);
    text.remove_prefix(begins ? beginning.size() : 0);
    return begins;
}

/// The key `first` + number - `least`, if there are so many.
std::optional<Key> numbered(std::string_view number, Key first, int least, int count) {
    const auto value = wholeNumberFrom(number);
    return value && *value >= least && *value < least + count
               ? std::optional(static_cast<Key>(code(first) + static_cast<int>(*value) - least))
               : std::nullopt;
}

std::optional<Key> keyFrom(std::string_view name) {
    const auto known =
        std::ranges::find_if(keyNames, [&](const KeyName& k) { return same(k.name, name); });
    if (known != keyNames.end()) {
        return known->key;
    }
    if (name.size() == 1) {
        const char sign = name.front();
        const char capital = lower(sign) == sign && sign >= 'a' && sign <= 'z'
                                 ? static_cast<char>(sign - 'a' + 'A')
                                 : sign;
        return showsItself(capital) ? std::optional(static_cast<Key>(capital)) : std::nullopt;
    }
    if (take(name, keypad)) {
        return numbered(name, Key::keypad0, 0, keypadDigits);
    }
    if (take(name, otherKey)) {
        constexpr int mostCodes = 1000;
        return numbered(name, Key{1}, 1, mostCodes);
    }
    return take(name, "F") ? numbered(name, Key::f1, 1, functionKeys) : std::nullopt;
}

} // namespace

std::string nameOf(const Shortcut& shortcut) {
    const bool tellsShift = shortcut.modifiers.shift && !isPlus(shortcut);
    return std::string(shortcut.modifiers.control ? "Ctrl+" : "") +
           (shortcut.modifiers.alt ? "Alt+" : "") + (tellsShift ? "Shift+" : "") +
           (isPlus(shortcut) ? std::string(plus) : nameOf(shortcut.key));
}

std::optional<Shortcut> shortcutFrom(std::string_view text) {
    Modifiers modifiers;
    for (bool more = true; more;) {
        const bool control = take(text, "Ctrl+");
        const bool alt = take(text, "Alt+");
        const bool shift = take(text, "Shift+");
        modifiers.control |= control;
        modifiers.alt |= alt;
        modifiers.shift |= shift;
        more = control || alt || shift;
    }
    if (text == plus) {
        modifiers.shift = true;
        return Shortcut{Key::equal, modifiers};
    }
    const auto key = keyFrom(text);
    return key ? std::optional(Shortcut{*key, modifiers}) : std::nullopt;
}

} // namespace splineloft::ui
