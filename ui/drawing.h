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

/// One picture inside one rectangle of the window: drawn in the order areas, ribbons, signs, and
/// clipped to `frame`, after `frame` was filled with `background`.
struct Picture {
    ScreenRect frame;
    Colour background;
    std::vector<Area> areas = {};
    std::vector<RibbonVertex> ribbons = {};
    std::vector<Sign> signs = {};
};

/// How a stroke looks.
struct StrokeStyle {
    float width = 1; ///< pixels
    float dash = 0, gap = 0;
    Colour colour;
};

/// Appends a stroke through `points`; a closed one joins its last point to its first.
void addStroke(Picture& picture, std::span<const ScreenPoint> points, const StrokeStyle& style,
               bool closed = false);

} // namespace splineloft::ui
