#include "ui/paint.h"

#include <cmath>

namespace splineloft::ui {
namespace {

/// Marks that are only an outline: what lies beneath shows through.
bool isHollow(Role role) {
    return role == Role::selected || role == Role::hovered || role == Role::snap;
}

Sign signOf(const SceneMark& mark, const Theme& theme, Colour background, double scale) {
    const auto pixels = static_cast<float>(scale);
    const Colour colour = colourOf(theme, mark.ink);
    Sign sign{.x = static_cast<float>(mark.at.x),
              .y = static_cast<float>(mark.at.y),
              .radius = static_cast<float>(markRadius(mark.ink, scale)),
              .outlineWidth = 1.5F * pixels,
              .angle = static_cast<float>(mark.angle),
              .shape = mark.shape,
              .fill = colour,
              .outline = background};
    if (isHollow(mark.ink.role)) {
        sign.fill.alpha = 0;
        sign.outline = colour;
    }
    return sign;
}

} // namespace

void addStroke(Picture& picture, std::span<const ScreenPoint> points, const StrokeStyle& style,
               bool closed) {
    if (points.empty()) {
        return;
    }
    RibbonVertex vertex{.dash = style.dash, .gap = style.gap, .colour = style.colour};
    const auto append = [&](ScreenPoint p, float halfWidth) {
        vertex.x = static_cast<float>(p.x);
        vertex.y = static_cast<float>(p.y);
        vertex.halfWidth = halfWidth;
        picture.ribbons.push_back(vertex);
    };
    append(closed ? points.back() : points.front(), 0);
    double along = 0;
    for (std::size_t i = 0; i < points.size() + (closed ? 1 : 0); ++i) {
        const ScreenPoint p = points[i % points.size()];
        if (i > 0) {
            const ScreenPoint before = points[i - 1];
            along += std::hypot(p.x - before.x, p.y - before.y);
        }
        vertex.along = static_cast<float>(along);
        append(p, style.width / 2);
    }
    append(closed && points.size() > 1 ? points[1] : points.back(), 0);
}

Picture paint(const Scene& scene, const Theme& theme, Colour background, double scale) {
    Picture picture{.frame = scene.frame, .background = background};
    for (const auto& area : scene.areas) {
        picture.areas.push_back({area.rect, colourOf(theme, area.ink)});
    }
    for (const auto& stroke : scene.strokes) {
        StrokeStyle style = strokeOf(theme, stroke.ink, scale);
        style.width *= stroke.emphasised ? 1.6F : 1.0F;
        addStroke(picture, stroke.points, style, stroke.closed);
    }
    for (const auto& mark : scene.marks) {
        picture.signs.push_back(signOf(mark, theme, background, scale));
    }
    return picture;
}

} // namespace splineloft::ui
