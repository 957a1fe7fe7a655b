// How a person looks at the document: everything on the screen that is not part of it. Undo never
// touches it, and it is not saved with the curves.
#pragma once

#include "core/document/document.h"
#include "core/spline/measure/sample.h"
#include "ui/canvas/selection.h"
#include "ui/drawing.h"

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace splineloft::ui {

/// Which two coordinates lie across and up the canvas. A curve with one coordinate is drawn as a
/// graph: its parameter across, its value up.
struct Axes {
    int across = 0, up = 1;
    bool operator==(const Axes&) const = default;
};

/// What the canvas shows: the middle of it, and how large a unit is.
struct Camera {
    PlanePoint centre;
    double pixelsPerUnit = 80; ///< framebuffer pixels
    bool operator==(const Camera&) const = default;
};

/// What is drawn besides the curves themselves.
struct Layers {
    bool grid = true;
    bool gridNumbers = true;
    bool polygon = true;
    bool labels = true;
    bool ladder = true;
    bool comb = false;
    bool beads = false;
    bool joints = false;
    bool frames = false;
    bool basis = true; ///< the strip of plots, of which it was the first
    bool operator==(const Layers&) const = default;
};

/// A layer by name, as the command line knows it. The grid is behind all of them, and no choice
/// among them.
struct NamedLayer {
    std::string_view name;
    bool Layers::* layer;
};
inline constexpr std::array namedLayers = {
    NamedLayer{"polygon", &Layers::polygon}, NamedLayer{"labels", &Layers::labels},
    NamedLayer{"ladder", &Layers::ladder},   NamedLayer{"comb", &Layers::comb},
    NamedLayer{"beads", &Layers::beads},     NamedLayer{"joints", &Layers::joints},
    NamedLayer{"frames", &Layers::frames},   NamedLayer{"basis", &Layers::basis}};

/// What the strip at the bottom shows of the active curve.
enum class Plot { basis, speed, acceleration, curvature };

/// The plots by name, in the order of their values.
inline constexpr std::array<std::string_view, 4> plotNames = {"basis", "speed", "acceleration",
                                                              "curvature"};

enum class Tool {
    select,
    pen,     ///< adds points at the end of the active curve
    newCurve ///< begins another curve with its next point, then goes on as the pen
};

enum class ThemeKind { dark, light };

/// One place to take hold of the frame around a selection: on which side it is, each -1, 0 or 1.
/// Neither is the ring that turns.
struct Grip {
    int across = 0, up = 0;
    bool turns() const { return across == 0 && up == 0; }
    bool operator==(const Grip&) const = default;
};

// Sizes of the panels that can be dragged, design pixels.
inline constexpr double usualStrip = 208;
inline constexpr double usualInspector = 312;

/// A curve whose name is being typed.
struct Renaming {
    std::size_t curve = 0;
    bool begun = false; ///< its field has the keyboard
};

/// A spot of one of the curves.
struct CurveHit {
    std::size_t curve = 0;
    Spot spot;
};

struct View {
    Camera camera;
    bool fitPending = true; ///< the next frame fits the document into the canvas
    Axes axes;
    Layers layers;
    Tool tool = Tool::select;
    ThemeKind theme = ThemeKind::dark;

    std::size_t activeCurve = 0;
    std::string firstFamily = "cardinal"; ///< of the first curve, where there is none yet
    std::optional<Renaming> renaming;
    Selection selection;
    std::optional<PointId> hovered;
    std::optional<CurveHit> ghost; ///< where a double click would insert
    std::optional<Grip> hoveredGrip;
    bool hoversStem = false;
    std::optional<PointId> exactEntry; ///< whose numbers are being typed in beside it

    Spot cursor; ///< u, on the active curve
    bool playing = false;
    double duration = 6;      ///< seconds from start to end
    Even pace = Even::length; ///< what playing, and the beads, are even in
    int beads = 24;
    Plot plot = Plot::basis;
    double strip = usualStrip;         ///< height of the plots, design pixels
    double inspector = usualInspector; ///< width, design pixels
    double interfaceScale = 1;         ///< how large the person wants everything to be
    bool log = false;                  ///< the messages stand in place of the plots
    bool presenting = false;           ///< full screen, for an audience: `Session::present`
    /// The camera from before, for design pixels; none where another document was opened meanwhile.
    std::optional<Camera> cameraAfterwards;
};

/// Turns to a curve; u goes to its start, for it may have fewer pieces than the one before.
inline void activate(View& view, std::size_t curve) {
    if (curve != view.activeCurve) {
        view.cursor = {};
    }
    view.activeCurve = curve;
}

} // namespace splineloft::ui
