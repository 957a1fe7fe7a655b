// A hand on the canvas without any toolkit: events go straight to `react`, edits to a session. And
// a few documents for it to work on.
#pragma once

#include "ui/session.h"

#include <initializer_list>
#include <string>

namespace splineloft::ui {

inline constexpr Modifiers withShift{.shift = true};
inline constexpr Modifiers withControl{.control = true};

/// Seven points on crooked places, enough for every family; a Bézier spline of two pieces.
Points sevenPoints();

/// A curve of a family through sevenPoints (six of them for a closed Bézier spline).
Curve curveOf(std::string_view family, bool closed = false);

/// The same number of points, with as many coordinates as wanted.
Curve curveOf(std::string_view family, int dimension);

Document documentOf(std::initializer_list<Curve> curves);
/// A document of one open cardinal spline.
Document plain();

/// How far apart two documents' tables of points lie at most; infinite where sizes differ.
double farthest(const Points& a, const Points& b);

class Hand {
  public:
    explicit Hand(Document document);

    Session session;

    void move(PlanePoint to, Modifiers held = {});
    void press(PlanePoint at, Modifiers held = {}, int clicks = 1);
    void release(PlanePoint at, Modifiers held = {});
    void pressOther(Button button, PlanePoint at);
    void releaseOther(Button button, PlanePoint at);
    /// Escape, or the window loses the focus.
    void cancel();

    void click(PlanePoint at, Modifiers held = {});
    void doubleClick(PlanePoint at);
    /// Presses at `from`, wanders through an odd place, and lets go at `to`.
    void drag(PlanePoint from, PlanePoint to, Modifiers held = {});
    void key(Key key, Modifiers held = {});

    const Curve& curve(std::size_t index = 0) const { return *session.document().curves[index]; }
    /// Where control point `index` of a curve is drawn.
    PlanePoint place(std::size_t index, std::size_t curve = 0) const;
    /// The point of the curve at a spot, on the canvas.
    PlanePoint placeAt(Spot spot, std::size_t curve = 0) const;
    Viewport viewport() const { return {session.view.camera, session.canvas}; }
    /// Number of undo steps.
    int steps() const;
    bool idle() const { return std::holds_alternative<Idle>(session.gesture); }

  private:
    void send(const PointerEvent& event);

    ScreenPoint last_;
};

} // namespace splineloft::ui
