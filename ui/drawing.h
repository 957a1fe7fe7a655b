// What the renderer draws: a few plain arrays, already in pixels and colours. The whole picture is
// made of ribbons (anti-aliased strokes), signs (discs, diamonds, squares ...) and areas.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace splineloft::ui {

/// Colour with straight (not premultiplied) alpha; each part 0..255.
struct Colour {
    std::uint8_t red = 0, green = 0, blue = 0, alpha = 255;
    bool operator==(const Colour&) const = default;
};

/// A place on the screen: framebuffer pixels from the window's top left corner, y down.
struct ScreenPoint {
    double x = 0, y = 0;
    bool operator==(const ScreenPoint&) const = default;
};

/// A rectangle on the screen, same pixels.
struct ScreenRect {
    double left = 0, top = 0, width = 0, height = 0;
    double right() const { return left + width; }
    double bottom() const { return top + height; }
    bool contains(ScreenPoint p) const {
        return p.x >= left && p.x < right() && p.y >= top && p.y < bottom();
    }
    bool operator==(const ScreenRect&) const = default;
};

/// One vertex of a ribbon. A stroke of n points takes n + 2 vertices: the point before the first
/// (or the first again) and the point after the last (or the last again), both with halfWidth 0,
/// and the n points between them. Instance i of the ribbon program reads vertices i .. i+3 and
/// draws the segment from i+1 to i+2, unless one of these two has halfWidth 0 (it leads from stroke
/// to stroke) or they coincide.
struct RibbonVertex {
    float x = 0, y = 0;
    float along = 0; ///< distance from the start of the stroke, pixels: dashes are laid along it
    float halfWidth = 0;     ///< pixels
    float dash = 0, gap = 0; ///< pixels; dash 0 is a solid stroke
    Colour colour;
};

enum class SignShape : std::uint8_t { disc, diamond, square, ring, triangle };

/// A marker: filled shape with an outline. `angle` turns it, radians clockwise on the screen.
struct Sign {
    float x = 0, y = 0;
    float radius = 0;       ///< pixels: half the width of the shape, outline included
    float outlineWidth = 0; ///< pixels
    float angle = 0;
    SignShape shape = SignShape::disc;
    Colour fill, outline;
};

/// A filled rectangle.
struct Area {
    ScreenRect rect;
    Colour fill;
};

/// How a stroke looks.
struct StrokeStyle {
    float width = 1; ///< pixels
    float dash = 0, gap = 0;
    Colour colour;
};

/// A place in the plane of the canvas: document units, y up.
struct PlanePoint {
    double x = 0, y = 0;
    bool operator==(const PlanePoint&) const = default;
};

class Revisions;

/// Bézier points of many pieces, in the plane. The renderer keeps its own copy of them from frame
/// to frame and fetches only what `revisions` says is new.
struct PieceTable {
    /// Piece i has the points i * stride .. i * stride + degree. Valid until the next frame is run.
    std::span<const PlanePoint> points;
    int degree = 3;                       ///< 1 to 3
    std::size_t stride = 4;               ///< points; 1 for the legs of a polygon
    std::size_t blockPoints = 0;          ///< points that a block of the revisions stands for
    const Revisions* revisions = nullptr; ///< as long as `points`
};

/// Neighbouring pieces that are drawn equally finely.
struct PieceRun {
    std::size_t first = 0, last = 0; ///< pieces [first, last)
    std::size_t segments = 1;        ///< straight ones for each piece; 1 where `step` is above 1
    std::size_t step = 1;            ///< pieces for which one straight segment stands
};

/// What of each piece is drawn.
enum class PieceLine : std::uint8_t { curve, firstLeg, lastLeg };

/// A stroke along pieces, of which the renderer makes ribbons by itself.
struct PieceStroke {
    PieceTable table;
    std::vector<PieceRun> runs;
    PieceLine line = PieceLine::curve;
    bool closed =
        false;         ///< the last piece meets the first; with stride 1, the last leg leads there
    PlanePoint centre; ///< the place that lies at `origin` on the screen
    ScreenPoint origin;
    double pixelsPerUnit = 1;
    StrokeStyle style;
    std::size_t ribbonsBefore = 0; ///< ribbon vertices of the picture that lie beneath it
};

/// One picture inside one rectangle of the window: drawn in the order areas, ribbons with the
/// strokes along pieces among them, signs, and clipped to `frame`, after `frame` was filled with
/// `background`.
struct Picture {
    ScreenRect frame;
    Colour background;
    std::vector<Area> areas = {};
    std::vector<RibbonVertex> ribbons = {};
    std::vector<PieceStroke> pieces = {};
    std::vector<Sign> signs = {};
};

/// Appends a stroke through `points`; a closed one joins its last point to its first. `laid` pixels
/// of it, which its dashes count, are not there.
void addStroke(Picture& picture, std::span<const ScreenPoint> points, const StrokeStyle& style,
               bool closed = false, double laid = 0);

} // namespace splineloft::ui
