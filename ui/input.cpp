// How far one frame may look into the events that wait. Dear ImGui before 1.87 sees only the state
// at the end of a frame: what changed there and back within it never happened, and the order of
// different kinds of events is lost. So a frame stops before an event that would undo, or should
// come after, one that it has already taken. Moves are never joined: the canvas sees every one.
#include "ui/input.h"

#include <algorithm>
#include <utility>

namespace splineloft::ui {

namespace {

// A key that does something to text rather than being text: escape up to the function keys.
bool editsText(Key key) {
    return key >= Key::escape && key < Key::leftShift;
}

bool modifies(Key key) {
    return key >= Key::leftShift && key <= Key::rightSuper;
}

// What the events taken so far have changed.
class Taken {
  public:
    bool allows(const PointerMoved&) const { return !button_; }
    bool allows(const PointerButton&) const { return !button_; }
    // The wheel acts where the pointer is, so it must not be felt before an earlier click is.
    bool allows(const WheelTurned&) const { return !button_; }
    // Control let go after Control+Z must not turn it into a plain Z.
    bool allows(const KeyChanged& event) const {
        const auto again = std::find(keys_.begin(), keys_.end(), event.key) != keys_.end();
        return !again && !(modifies(event.key) && modifiable_);
    }
    // Text is inserted before keys act: typed after a Backspace, it waits for the next frame.
    bool allows(const TextTyped&) const { return !edited_; }
    // Losing the focus ends a drag, so what went before must have been seen.
    bool allows(const FocusChanged&) const { return !any_; }
    bool allows(const FilesDropped&) const { return true; }
    bool allows(const CloseAsked&) const { return true; }

    void note(const InputEvent& event) {
        any_ = true;
        std::visit([this](const auto& known) { note(known); }, event);
    }

  private:
    void note(const PointerButton&) { button_ = modifiable_ = true; }
    void note(const WheelTurned&) { modifiable_ = true; }
    void note(const KeyChanged& event) {
        keys_.push_back(event.key);
        edited_ = edited_ || (event.down && editsText(event.key));
        modifiable_ = modifiable_ || !modifies(event.key);
    }
    template <typename Event> void note(const Event&) {}

    bool any_ = false;
    bool button_ = false;
    bool edited_ = false;
    bool modifiable_ = false; // something whose meaning depends on the modifiers
    std::vector<Key> keys_;
};

} // namespace

void InputQueue::push(InputEvent event) {
    events_.push_back(std::move(event));
}

std::vector<InputEvent> InputQueue::takeFrame() {
    std::vector<InputEvent> frame;
    Taken taken;
    while (!events_.empty()) {
        const auto allowed =
            std::visit([&](const auto& event) { return taken.allows(event); }, events_.front());
        if (!allowed) {
            break;
        }
        taken.note(events_.front());
        frame.push_back(std::move(events_.front()));
        events_.pop_front();
    }
    return frame;
}

} // namespace splineloft::ui
