#include "ui/settings.h"

#include "core/formats/json_text.h"
#include "core/formats/value_reader.h"

#include <algorithm>
#include <array>
#include <span>
#include <tuple>

namespace splineloft::ui {
namespace {

// --- the list of what is remembered
// ---------------------------------------------------------------

/// A number, kept within sensible bounds.
template <class Owner, class Number> struct Measure {
    std::string_view key;
    Number Owner::* field;
    double least, most;
};

template <class Owner> struct Switch {
    std::string_view key;
    bool Owner::* field;
};

/// One of a few, by their names in the order of their values.
template <class Owner, class Enum, std::size_t count> struct Choice {
    std::string_view key;
    Enum Owner::* field;
    std::array<std::string_view, count> names;
};

/// Of a view: here belongs, in one line, whatever else outlives a document.
constexpr std::tuple ofView = {
    Choice<View, ThemeKind, 2>{"theme", &View::theme, {"dark", "light"}},
    Measure<View, double>{"strip", &View::strip, 60, 2000},
    Measure<View, double>{"inspector", &View::inspector, 120, 2000},
    Measure<View, double>{"interfaceScale", &View::interfaceScale, 0.5, 2},
    Switch<View>{"log", &View::log},
    Measure<View, double>{"duration", &View::duration, 0.1, 3600},
    Choice<View, Even, 2>{"pace", &View::pace, {"parameter", "length"}},
    Measure<View, int>{"beads", &View::beads, 2, 10'000},
    Choice<View, Plot, plotNames.size()>{"plot", &View::plot, plotNames}};

constexpr std::tuple ofHabits = {
    Switch<Habits>{"systemDialogs", &Habits::systemDialogs},
    Measure<Habits, double>{"windowWidth", &Habits::windowWidth, 320, 16'384},
    Measure<Habits, double>{"windowHeight", &Habits::windowHeight, 240, 16'384}};

constexpr std::string_view layersKey = "layers";

static_assert(static_cast<int>(Even::parameter) == 0 && static_cast<int>(Even::length) == 1);
static_assert(plotNames[static_cast<std::size_t>(Plot::curvature)] == "curvature");
static_assert(static_cast<int>(ThemeKind::dark) == 0 && static_cast<int>(ThemeKind::light) == 1);

// --- writing it
// -----------------------------------------------------------------------------------

template <class Owner, class Number>
void write(JsonText& text, const Measure<Owner, Number>& kept, const Owner& owner) {
    text.key(kept.key);
    text.number(static_cast<double>(owner.*kept.field));
}

template <class Owner> void write(JsonText& text, const Switch<Owner>& kept, const Owner& owner) {
    text.key(kept.key);
    text.boolean(owner.*kept.field);
}

template <class Owner, class Enum, std::size_t count>
void write(JsonText& text, const Choice<Owner, Enum, count>& kept, const Owner& owner) {
    text.key(kept.key);
    text.text(kept.names.at(static_cast<std::size_t>(owner.*kept.field)));
}

template <class List, class Owner>
void writeAll(JsonText& text, const List& list, const Owner& owner) {
    std::apply([&](const auto&... kept) { (write(text, kept, owner), ...); }, list);
}

// --- reading it
// -----------------------------------------------------------------------------------

/// "this, that or another".
std::string oneOf(std::span<const std::string_view> names) {
    std::string words(names.front());
    for (std::size_t i = 1; i < names.size(); ++i) {
        words += (i + 1 < names.size() ? ", " : " or ") + std::string(names[i]);
    }
    return words;
}

/// Reads what is remembered from the members of one object.
class SettingsReader {
  public:
    SettingsReader(ValueReader& values, const JsonValue& object, const JsonPlace& place)
        : values_(values), members_(values.membersOf(object, place)), place_(place) {}

    template <class Owner, class Number>
    void read(const Measure<Owner, Number>& kept, Owner& owner) {
        if (const auto* value = find(kept.key)) {
            const double number = values_.number(*value, {place_, kept.key});
            owner.*kept.field = static_cast<Number>(std::clamp(number, kept.least, kept.most));
        }
    }

    template <class Owner> void read(const Switch<Owner>& kept, Owner& owner) {
        if (const auto* value = find(kept.key)) {
            owner.*kept.field = values_.boolean(*value, {place_, kept.key});
        }
    }

    template <class Owner, class Enum, std::size_t count>
    void read(const Choice<Owner, Enum, count>& kept, Owner& owner) {
        if (const auto* value = find(kept.key)) {
            const auto text = values_.text(*value, {place_, kept.key});
            const auto name = std::ranges::find(kept.names, text);
            if (name == kept.names.end()) {
                values_.refuse({place_, kept.key}, "is " + inQuotes(text), oneOf(kept.names));
            } else {
                owner.*kept.field = static_cast<Enum>(name - kept.names.begin());
            }
        }
    }

    template <class List, class Owner> void readAll(const List& list, Owner& owner) {
        std::apply([&](const auto&... kept) { (read(kept, owner), ...); }, list);
    }

    /// The member of that key, or null.
    const JsonValue* find(std::string_view key) const {
        return ValueReader::optional(members_, key);
    }

  private:
    ValueReader& values_;
    ValueReader::Members members_;
    const JsonPlace& place_;
};

} // namespace

void keepRemembered(const View& from, View& to) {
    std::apply([&](const auto&... kept) { ((to.*kept.field = from.*kept.field), ...); }, ofView);
    to.layers = from.layers;
}

std::string settingsText(const Session& session) {
    JsonText text;
    text.beginObject();
    writeAll(text, ofView, session.view);
    text.key(layersKey);
    text.beginObject(Flow::inLine);
    for (const auto& [name, layer] : namedLayers) {
        write(text, Switch<Layers>{name, layer}, session.view.layers);
    }
    text.end();
    writeAll(text, ofHabits, session.habits);
    text.end();
    return std::move(text).finished();
}

Result<Done> applySettings(Session& session, std::string_view text) {
    const auto tape = readJson(text);
    if (!tape) {
        return tape.refusal();
    }
    const JsonPlace top;
    ValueReader values;
    SettingsReader reader(values, tape->root(), top);
    View view;
    keepRemembered(session.view, view);
    reader.readAll(ofView, view);
    if (const auto* layers = reader.find(layersKey)) {
        const JsonPlace place(top, layersKey);
        SettingsReader each(values, *layers, place);
        for (const auto& [name, layer] : namedLayers) {
            each.read(Switch<Layers>{name, layer}, view.layers);
        }
    }
    auto habits = session.habits;
    reader.readAll(ofHabits, habits);
    if (values.refusal()) {
        return *values.refusal();
    }
    keepRemembered(view, session.view);
    session.habits = habits;
    return Done{};
}

} // namespace splineloft::ui
