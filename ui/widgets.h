// The few widgets that Dear ImGui does not have: a slider that knows its neutral value, a number
// field for exact values, a choice of a few, a chip.
#pragma once

#include "core/spline/family.h"
#include "ui/edit.h"
#include "ui/stage.h"

#include <optional>
#include <span>
#include <string>

namespace splineloft::ui {

/// A value that a widget was given, and whether the hand is still on it.
struct Turned {
    double value = 0;
    Phase phase = Phase::preview;
};

/// A field that shows a number exactly and takes a new one on Enter, Tab or a click elsewhere; sums
/// and products are worked out. What is no number comes back as not-a-number, to be refused in
/// words where it would have gone.
std::optional<double> numberField(const char* id, double value, double width);

/// What became of a text that is being typed.
struct Typing {
    bool begun = false;              ///< the field has the keyboard
    bool over = false;               ///< it has lost it again
    std::optional<std::string> text; ///< another than before, where one was entered
};

/// A field for a text, entered by Enter, Tab or a click elsewhere; Escape leaves the old one.
Typing textField(const char* id, const std::string& text, float width, bool takeKeyboard);

/// Name, symbol, value and track of one parameter. A mark shows the neutral value, to which the
/// knob is drawn; a double click returns to it; ratios slide logarithmically; Escape in mid-drag
/// cancels.
std::optional<Turned> parameterSlider(const Parameter& parameter, double value, const Stage& stage);

/// Buttons side by side, one of them pressed. Returns the one that was clicked.
std::optional<int> choiceOf(const char* id, std::span<const std::string_view> names, int chosen,
                            const Stage& stage, double width);
/// The same, each button as wide as its name wants.
std::optional<int> choiceOf(const char* id, std::span<const std::string_view> names, int chosen,
                            const Stage& stage);

/// A rounded label; struck through where the property does not hold.
struct Chip {
    std::string text;
    bool holds = true;
};

/// Chips side by side, on as many lines as they need.
void chips(std::span<const Chip> row, const Stage& stage);

/// A small checkbox; returns whether it was clicked.
bool toggle(const char* label, bool& on, const Stage& stage);

/// A small button without a frame until it is pressed or touched; returns whether it was clicked.
bool quietButton(const char* label, bool pressed, const Stage& stage);
float quietButtonWidth(const std::string& words, const Stage& stage);

/// The text with line ends put in at spaces, for the font in use. (Dear ImGui would also break
/// within 3.1.)
std::string brokenAtSpaces(const std::string& text, float width);

/// As much of a text as fits, for the font in use: whole parts between " · " where there are any,
/// else with "…" at the end.
std::string cutToFit(const std::string& text, float width);

/// As much of the end of a text as fits, for the font in use, with "…" before it where some is
/// gone: of a path one wants to see where it leads.
std::string endThatFits(const std::string& text, float width);

/// Small quiet text, wrapped.
void quietText(const std::string& text, const Stage& stage);

/// Text that explains the widget before it while the pointer rests there.
void explain(const std::string& text);

} // namespace splineloft::ui
