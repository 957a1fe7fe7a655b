// What hands do, as values: the window turns the toolkit's callbacks into these, and so do the
// headless tests. Everything the interface ever learns of the outside comes through this queue.
#pragma once

#include <cstdint>
#include <deque>
#include <string>
#include <variant>
#include <vector>

namespace splineloft::ui {

/// Modifier keys held while an event happened.
struct Modifiers {
    bool shift = false;
    bool control = false;
    bool alt = false;
    bool operator==(const Modifiers&) const = default;
};

enum class Button : std::uint8_t { left, right, middle };

/// A key on the keyboard. Printable keys have the code of their capital letter or sign; the values
/// are those of GLFW, so that the window passes them through.
enum class Key : int {
    space = 32,
    comma = 44,
    minus = 45,
    period = 46,
    slash = 47,
    digit0 = 48,
    digit9 = 57,
    equal = 61,
    a = 65,
    b,
    c,
    d,
    e,
    f,
    g,
    h,
    i,
    j,
    k,
    l,
    m,
    n,
    o,
    p,
    q,
    r,
    s,
    t,
    u,
    v,
    w,
    x,
    y,
    z,
    escape = 256,
    enter,
    tab,
    backspace,
    insert,
    del,
    right,
    left,
    down,
    up,
    pageUp,
    pageDown,
    home,
    end,
    f1 = 290,
    f2,
    f11 = 300,
    keypad0 = 320,
    keypadEnter = 335,
    leftShift = 340,
    leftControl,
    leftAlt,
    leftSuper,
    rightShift,
    rightControl,
    rightAlt,
    rightSuper
};

/// Positions are in framebuffer pixels from the top left corner of the window, y down.
struct PointerMoved {
    double x, y;
};
struct PointerButton {
    Button button;
    bool down;
    Modifiers modifiers;
};
struct WheelTurned {
    double dx, dy;
    Modifiers modifiers;
};
struct KeyChanged {
    Key key;
    bool down;
    bool repeat;
    Modifiers modifiers;
};
struct TextTyped {
    char32_t character;
};
struct FocusChanged {
    bool focused;
};
struct FilesDropped {
    std::vector<std::string> paths;
};
struct CloseAsked {};

using InputEvent = std::variant<PointerMoved, PointerButton, WheelTurned, KeyChanged, TextTyped,
                                FocusChanged, FilesDropped, CloseAsked>;

/// Events in the order in which they happened. A frame takes events only as far as the next change
/// of a button or key after the first, so that a press, a move and a release that arrive together
/// are still seen as three moments (Dear ImGui before 1.87 would lose the drag).
class InputQueue {
  public:
    void push(InputEvent event);
    bool empty() const { return events_.empty(); }
    /// The events for the next frame, oldest first; empty when nothing happened.
    std::vector<InputEvent> takeFrame();

  private:
    std::deque<InputEvent> events_;
};

} // namespace splineloft::ui
