// The frame around several selected points: grips on its sides and corners scale the selection, the
// ring above it turns it.
#pragma once

#include "core/document/plane_map.h"
#include "ui/canvas/viewport.h"

#include <optional>
#include <vector>

namespace splineloft::ui {

/// A box of the plane, its sides parallel to the axes.
struct PlaneBox {
    PlanePoint low, high;
    double width() const { return high.x - low.x; }
    double height() const { return high.y - low.y; }
    PlanePoint middle() const { return {0.5 * (low.x + high.x), 0.5 * (low.y + high.y)}; }
};

/// The box around the selected control points; nothing where there are fewer than two, or all lie
/// in one place. Tangents do not count.
std::optional<PlaneBox> boxOfSelection(const Document& document, const View& view);

/// The frame as it stands on the screen, a little outside of its points.
struct Gizmo {
    PlaneBox box;
    ScreenRect frame;
    ScreenPoint ring; ///< where the one is that turns

    ScreenPoint placeOf(const Grip& grip) const;
    /// All but those that would pull apart what lies on a line across.
    std::vector<Grip> grips() const;
};

/// The frame around a box, with the ring above it, or wherever it is in view.
Gizmo gizmoAround(const PlaneBox& box, const Viewport& viewport, double scale);

/// The frame of the selection, while the tool selects.
std::optional<Gizmo> gizmoOf(const Document& document, const View& view, const Viewport& viewport,
                             double scale);

/// The grip within reach of a place on the screen.
std::optional<Grip> gripAt(const Gizmo& gizmo, ScreenPoint at, double scale);

/// How a hand pulls on a grip.
struct Pull {
    Grip grip;
    PlanePoint from, to;      ///< where the grip was taken, and where it is now
    bool evenly = false;      ///< scale both axes alike; turn by multiples of 45 degrees
    bool aboutMiddle = false; ///< instead of the side opposite
    double snap = 0;          ///< scaled sides lie on multiples of this; 0: anywhere
    bool byFifteen = false;   ///< turn by multiples of 15 degrees
};

/// What a pull does to the box: a map of the plane, and the same in words ("150 % × 80 %", "30°").
struct Transform {
    PlaneMap map;
    std::string words;
};
Transform transformOf(const PlaneBox& box, const Pull& pull);

} // namespace splineloft::ui
