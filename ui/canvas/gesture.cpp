#include "ui/canvas/gestures/steps.h"

#include <algorithm>
#include <cmath>

namespace splineloft::ui {
namespace {

// A hand trembles: below this a press and release is a click. Design pixels.
constexpr double clickSlack = 3;

} // namespace

Reaction react(const Gesture& gesture, const View& view, const PointerEvent& event,
               const Situation& situation) {
    return std::visit([&](const auto& state) { return step(state, view, event, situation); },
                      gesture);
}

ScreenRect spanned(ScreenPoint a, ScreenPoint b) {
    return {std::min(a.x, b.x), std::min(a.y, b.y), std::abs(a.x - b.x), std::abs(a.y - b.y)};
}

Reaction stay(const Gesture& gesture, const View& view) {
    return {gesture, view};
}

bool beyondClick(ScreenPoint a, ScreenPoint b, const Situation& situation) {
    return std::hypot(a.x - b.x, a.y - b.y) > clickSlack * situation.scale;
}

bool givesUp(const PointerEvent& event) {
    return event.kind == Kind::cancel ||
           (event.kind == Kind::press && event.button == Button::right);
}

bool letsGo(const PointerEvent& event) {
    return event.kind == Kind::release && event.button == Button::left;
}

} // namespace splineloft::ui
