// The one place where the plane of the canvas and the pixels of the screen meet.
#pragma once

#include "core/spline/piece.h"
#include "ui/canvas/view.h"

namespace splineloft::ui {

/// A camera looking through a rectangle of the window.
struct Viewport {
    Camera camera;
    ScreenRect frame;

    ScreenPoint toScreen(PlanePoint p) const;
    PlanePoint toPlane(ScreenPoint p) const;
    /// Length on the plane of so many pixels.
    double toPlane(double pixels) const { return pixels / camera.pixelsPerUnit; }
};

/// The camera after zooming by `factor` so that what is under `at` stays there.
Camera zoomed(const Viewport& viewport, ScreenPoint at, double factor);

/// The camera after dragging the plane by so many pixels.
Camera panned(const Camera& camera, double dx, double dy);

/// The camera that shows the box with some space around it.
Camera fitted(PlanePoint low, PlanePoint high, const ScreenRect& frame, double margin);

/// The finest distance of grid lines, in units, that leaves them at least `pixels` apart: 1, 2 or 5
/// times a power of ten.
double gridStep(const Camera& camera, double pixels);

/// The multiple of `step` nearest to `value`, as its decimals read.
double roundedTo(double value, double step);

/// The curve as it lies in the plane of the canvas.
Pieces flattened(const Pieces& pieces, const Axes& axes);

/// Places of all control points in that plane.
std::vector<PlanePoint> controlPlaces(const Curve& curve, const Axes& axes);

/// A displacement in the plane as one of the curve's coordinates.
Point liftedDelta(const Curve& curve, const Axes& axes, double dx, double dy);

/// The document with these points moved by a displacement in the plane, each curve's in its own
/// coordinates.
Document movedInPlane(const Document& document, const std::vector<PointId>& ids, const Axes& axes,
                      double dx, double dy);

/// `place` moved so that it lies under `at` in the plane; other coordinates stay.
Point lifted(const Curve& curve, const Axes& axes, Point place, PlanePoint at);

} // namespace splineloft::ui
