// The one place where the plane of the canvas and the pixels of the screen meet.
#pragma once

#include "core/spline/curve.h"
#include "ui/canvas/box_tree.h"
#include "ui/canvas/view.h"

#include <optional>

namespace splineloft::ui {

/// A camera looking through a rectangle of the window.
struct Viewport {
    Camera camera;
    ScreenRect frame;

    ScreenPoint toScreen(PlanePoint p) const;
    PlanePoint toPlane(ScreenPoint p) const;
    /// Length on the plane of so many pixels.
    double toPlane(double pixels) const { return pixels / camera.pixelsPerUnit; }
    /// What lies under a rectangle, and a little more than that rather than less.
    PlaneBounds boxUnder(const ScreenRect& rect) const;
    /// What can be seen, with what sticks out by so many pixels into the frame.
    PlaneBounds visible(double overhang) const;
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

/// Where single control points of a curve lie in that plane, and the tips of their tangents: a
/// third of each away, where the Bézier handle is (handle = tangent / 3).
class CurvePlaces {
  public:
    CurvePlaces(const Curve& curve, const Axes& axes);
    PlanePoint point(std::size_t index) const;
    PlanePoint tangentTip(std::size_t index) const;

  private:
    const Curve& curve_;
    Axes axes_;
    std::vector<double> across_; ///< of a curve of one coordinate
};

/// The same for all curves of a document.
class PointPlaces {
  public:
    PointPlaces(const Document& document, const Axes& axes) : document_(document), axes_(axes) {}
    /// Quick for points that are asked for curve by curve.
    PlanePoint operator[](const PointId& id);

  private:
    const Document& document_;
    Axes axes_;
    std::size_t curve_ = 0;
    std::optional<CurvePlaces> places_; ///< of that curve
};

/// A displacement in the plane as one of the curve's coordinates.
Point liftedDelta(const Curve& curve, const Axes& axes, double dx, double dy);

/// The document with these points moved by a displacement in the plane, each curve's in its own
/// coordinates.
Document movedInPlane(const Document& document, const std::vector<PointId>& ids, const Axes& axes,
                      double dx, double dy);

/// `place` moved so that it lies under `at` in the plane; other coordinates stay.
Point lifted(const Curve& curve, const Axes& axes, Point place, PlanePoint at);

} // namespace splineloft::ui
