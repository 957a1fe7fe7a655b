// What a hand is in the middle of doing on the canvas, and what its next movement does. Pure:
// events and the present state in, the next state and perhaps an edit out.
#pragma once

#include "ui/canvas/gizmo.h"
#include "ui/canvas/pick.h"
#include "ui/canvas/stems.h"
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
    int clicks = 1;    ///< 2 for the press of a double click
    bool pans = false; ///< Space is held: a press moves the view, whatever is under it
};

struct Idle {};

/// What a move keeps to: nothing, an axis, or the line at 45 degrees that rises or falls.
enum class Course { free, across, up, rising, falling };

/// What a hand is held to, as it is shown: a line through the place where it is, and
/// the place it snapped to.
struct Held {
    Course course = Course::free;
    PlanePoint through{};
    std::optional<PlanePoint> to = std::nullopt;
};

/// A button is down on a control point; beyond a few pixels it moves all that are selected.
struct DraggingPoints {
    std::vector<PointId> ids;
    PointId grabbed;
    ScreenPoint from;
    bool moved = false;
    /// What letting go does to the selection, if it has not moved.
    enum class Click { selects, selectsOnly, deselects } click = Click::selects;
    Held held = {};
};

/// A rubber band; `kept` stays selected.
struct Boxing {
    ScreenPoint from, now;
    Selection kept;
};

struct Panning {
    ScreenPoint last;
    Button button = Button::middle; ///< that began it
};

/// u follows the pointer along the active curve.
struct SlidingCursor {};

/// The pen has put down a point, and may still pull its handles out.
struct PlacingPoint {
    PointId point;
    Document placed;
    ScreenPoint from;
    Held held = {};
};

/// A grip of the frame around the selection is being pulled.
struct Transforming {
    std::vector<PointId> ids;
    PlaneBox box; ///< of the selection when it was taken
    Grip grip;
    ScreenPoint from, now;
    bool moved = false;
    Transform done = {}; ///< what it does so far
};

/// A number at a point is being slid along its stem.
struct SlidingStem {
    Stem stem; ///< as it was when it was taken
    ScreenPoint from;
    bool moved = false;
};

using Gesture = std::variant<Idle, DraggingPoints, Boxing, Panning, SlidingCursor, PlacingPoint,
                             Transforming, SlidingStem>;

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
