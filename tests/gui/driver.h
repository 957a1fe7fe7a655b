// Runs the whole interface without a window: real events through the queue, one frame at a time.
//
// Widgets are found by asking Dear ImGui's keyboard navigation: it notes the rectangle of the item
// on which it stands, so for one frame we put it onto the item that we look for. The items' ids are
// worked out from their labels, as Dear ImGui itself does.
#pragma once

#include "ui/frame.h"
#include "ui/session.h"

#include <initializer_list>
#include <optional>
#include <set>
#include <string>
#include <variant>
#include <vector>

namespace splineloft::ui {

/// A widget: the name of its window, then the labels and numbers on the stack of ids.
struct Widget {
    std::string window;
    std::vector<std::variant<std::string, int>> path;
};

/// Parts of the inspector.
Widget slider(std::string key);
Widget sliderField(std::string key);
Widget pointField(std::size_t index, int coordinate);
Widget tangentField(std::size_t index, int coordinate);
Widget pointRow(std::size_t index);
Widget inInspector(std::string label);
Widget inDialog(std::string label);

class Driver {
  public:
    explicit Driver(Document document = {}, Screen screen = {});
    ~Driver();
    Driver(const Driver&) = delete;
    Driver& operator=(const Driver&) = delete;

    Session session;
    InputQueue queue;
    Screen screen;
    FrameResult result; ///< of the last frame

    /// Runs frames until the queue is empty, then one more, so that everything has settled.
    void settle();
    void frames(int count, double seconds = 1.0 / 60);

    void move(ScreenPoint to);
    void press(ScreenPoint at, Button button = Button::left);
    void release(Button button = Button::left);
    void click(ScreenPoint at);
    void doubleClick(ScreenPoint at);
    void drag(ScreenPoint from, ScreenPoint to);
    void hold(Key modifier);
    void letGo(Key modifier);
    void key(Key key, Modifiers held = {});
    void type(const std::string& ascii);
    void send(InputEvent event);

    /// Where a widget is now; nothing where it is not drawn. Scrolls the inspector to it.
    std::optional<ScreenRect> find(const Widget& widget);
    /// Its middle. Fails the test where it is not there.
    ScreenPoint middle(const Widget& widget);
    bool has(const Widget& widget) { return find(widget).has_value(); }
    void click(const Widget& widget) { click(middle(widget)); }
    /// Types into a number field and presses a key to enter it.
    void enter(const Widget& field, const std::string& text, Key with = Key::enter);
    /// Opens the n-th menu and takes its n-th entry (lines between them do not count).
    void takeFromMenu(int menu, int entry);
    /// The option of a combo box that is open.
    Widget option(std::string label) const;

    /// Id of the item under the pointer; 0 where there is none.
    unsigned hoveredItem() const;
    /// What is wrong with the picture of the last frame or the view, in words; empty: nothing.
    std::string faults() const;
    /// Where a point of the plane is on the screen.
    ScreenPoint at(PlanePoint place) const;
    ScreenPoint atPoint(std::size_t index) const;
    Curve curve() const { return *session.document().curves.at(session.view.activeCurve); }
    int steps() const;
    std::string hint() const;

  private:
    std::optional<ScreenRect> rectOf(const Widget& widget);

    Modifiers held_;
    double fontScale_ = 0; // of the fonts that are loaded
};

/// What was asked of the program last, if that was a `Wanted`.
template <class Wanted> const Wanted* lastRequest(const Driver& driver) {
    const auto& all = driver.session.requests;
    return all.empty() ? nullptr : std::get_if<Wanted>(&all.back());
}

/// The places where DejaVu Sans, the font of the program, is usually installed.
Fonts testFonts();

} // namespace splineloft::ui
