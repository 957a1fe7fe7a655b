// What a hand is in the middle of doing on the canvas, and what its next movement does. Pure:
// events and the present state in, the next state and perhaps an edit out.
#pragma once

#include "ui/canvas/pick.h"
#include "ui/edit.h"
#include "ui/input.h"

#include <variant>

namespace splineloft::ui {

/// One event of the pointer on the canvas.
struct PointerEvent {
    enum class Kind { move, press, release, cancel };
    Kind kind = Kind::move;
    ScreenPoint at;
    Button button = Button::left; ///< of a press or release
    Modifiers modifiers;
    int clicks = 1; ///< 2 for the press of a double click
};

struct Idle {};

/// A button is down on a control point; beyond a few pixels it moves all that are selected.
struct DraggingPoints {
    std::vector<PointId> ids;
    PointId grabbed;
    ScreenPoint from;
    bool moved = false;
    bool selectOnlyThis = false; ///< on release, if it has not moved
    std::optional<PlanePoint> snappedTo = std::nullopt;
};

/// A rubber band; `kept` stays selected.
struct Boxing {
    ScreenPoint from, now;
    std::set<PointId> kept;
};

struct Panning {
    ScreenPoint last;
};

/// u follows the pointer along the active curve.
struct SlidingCursor {};

/// The pen has put down a point, and may still pull its handles out.
struct PlacingPoint {
    PointId point;
    Document placed;
    ScreenPoint from;
};

using Gesture = std::variant<Idle, DraggingPoints, Boxing, Panning, SlidingCursor, PlacingPoint>;

/// What a gesture can see.
struct Situation {
    const Document& settled;
    const Document& live;
    const Studies& studies;
    Viewport viewport;
    double scale = 1; ///< pixels per design pixel
};

/// What an event leads to.
struct Reaction {
    Gesture gesture;
    View view;
    std::optional<Edit> edit = std::nullopt;
};

Reaction react(const Gesture& gesture, const View& view, const PointerEvent& event,
               const Situation& situation);

/// The rectangle between two corners.
ScreenRect spanned(ScreenPoint a, ScreenPoint b);

} // namespace splineloft::ui
