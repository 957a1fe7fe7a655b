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
              .radius = static_cast<float>(mark.size * markRadius(mark.ink, scale)),
              .outlineWidth = mark.size < 1 ? 0 : 1.5F * pixels,
              .angle = static_cast<float>(mark.angle),
              .shape = mark.shape,
              .fill = colour,
              .outline = background};
    if (isHollow(mark.ink.role)) {
        sign.fill.alpha = 0;
        sign.outline = colour;
    } else if (mark.ink.role == Role::grip) {
        sign.fill = background;
        sign.outline = colour;
    }
    return sign;
}

/// The points that differ from the one before by what could ever be seen; a repeated point in a
/// translucent stroke would show as a bead.
std::vector<ScreenPoint> withoutRepeats(std::span<const ScreenPoint> points, bool closed) {
    constexpr double least = 1e-3; // pixels
    const auto same = [](ScreenPoint a, ScreenPoint b) {
        return std::abs(a.x - b.x) < least && std::abs(a.y - b.y) < least;
    };
    std::vector<ScreenPoint> apart;
    for (const auto& point : points) {
        if (apart.empty() || !same(apart.back(), point)) {
            apart.push_back(point);
        }
    }
    while (closed && apart.size() > 1 && same(apart.front(), apart.back())) {
        apart.pop_back();
    }
    return apart;
}

} // namespace

void addStroke(Picture& picture, std::span<const ScreenPoint> points, const StrokeStyle& style,
               bool closed, double laid) {
    const auto apart = withoutRepeats(points, closed);
    if (apart.empty()) {
        return;
    }
    RibbonVertex vertex{.dash = style.dash, .gap = style.gap, .colour = style.colour};
    const auto append = [&](ScreenPoint p, float halfWidth) {
        vertex.x = static_cast<float>(p.x);
        vertex.y = static_cast<float>(p.y);
        vertex.halfWidth = halfWidth;
        picture.ribbons.push_back(vertex);
    };
    append(closed ? apart.back() : apart.front(), 0);
    double along = laid;
    for (std::size_t i = 0; i < apart.size() + (closed ? 1 : 0); ++i) {
        const ScreenPoint p = apart[i % apart.size()];
        if (i > 0) {
            const ScreenPoint before = apart[i - 1];
            along += std::hypot(p.x - before.x, p.y - before.y);
        }
        vertex.along = static_cast<float>(along);
        append(p, style.width / 2);
    }
    append(closed && apart.size() > 1 ? apart[1] : apart.back(), 0);
}

Picture paint(const Scene& scene, const Theme& theme, Colour background, double scale) {
    Picture picture{.frame = scene.frame, .background = background};
    for (const auto& area : scene.areas) {
        picture.areas.push_back({area.rect, colourOf(theme, area.ink)});
    }
    auto pieces = scene.pieces.begin();
    const auto addPieces = [&](std::size_t strokes) {
        for (; pieces != scene.pieces.end() && pieces->strokesBefore <= strokes; ++pieces) {
            picture.pieces.push_back(pieces->stroke);
            picture.pieces.back().style = strokeOf(theme, pieces->ink, scale);
            picture.pieces.back().ribbonsBefore = picture.ribbons.size();
        }
    };
    for (std::size_t i = 0; i < scene.strokes.size(); ++i) {
        addPieces(i);
        const auto& stroke = scene.strokes[i];
        StrokeStyle style = strokeOf(theme, stroke.ink, scale);
        style.width *= stroke.emphasised ? 1.6F : 1.0F;
        addStroke(picture, stroke.points, style, stroke.closed, stroke.laid);
    }
    addPieces(scene.strokes.size());
    for (const auto& mark : scene.marks) {
        picture.signs.push_back(signOf(mark, theme, background, scale));
    }
    return picture;
}

} // namespace splineloft::ui
