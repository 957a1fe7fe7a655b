#include "ui/canvas/labels.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace splineloft::ui {
namespace {

bool overlap(const ScreenRect& a, const ScreenRect& b) {
    return a.left < b.right() && b.left < a.right() && a.top < b.bottom() && b.top < a.bottom();
}

bool isInside(const ScreenRect& inner, const ScreenRect& outer) {
    return inner.left >= outer.left && inner.top >= outer.top && inner.right() <= outer.right() &&
           inner.bottom() <= outer.bottom();
}

/// Directions from the point to its label, the most pleasing first; y down.
constexpr std::array<ScreenPoint, 8> directions = {{{-0.7, -0.7},
                                                    {0.7, -0.7},
                                                    {0.0, -1.0},
                                                    {0.7, 0.7},
                                                    {-0.7, 0.7},
                                                    {0.0, 1.0},
                                                    {1.0, 0.0},
                                                    {-1.0, 0.0}}};

ScreenRect rectToward(const SceneLabel& label, TextSize size, ScreenPoint direction, double reach) {
    const double x = label.at.x + direction.x * reach + 0.5 * size.width * (direction.x - 1);
    const double y = label.at.y + direction.y * reach + 0.5 * size.height * (direction.y - 1);
    return {std::round(x), std::round(y), size.width, size.height};
}

} // namespace

std::vector<PlacedLabel> placeLabels(const Scene& scene, const MeasureText& measure,
                                     double markRadius) {
    std::vector<ScreenRect> taken;
    for (const auto& mark : scene.marks) {
        taken.push_back(
            {mark.at.x - markRadius, mark.at.y - markRadius, 2 * markRadius, 2 * markRadius});
    }
    const auto isFree = [&](const ScreenRect& rect) {
        return isInside(rect, scene.frame) &&
               std::ranges::none_of(taken, [&](const auto& other) { return overlap(rect, other); });
    };
    std::vector<PlacedLabel> placed;
    const auto put = [&](const SceneLabel& label, const ScreenRect& rect) {
        placed.push_back({&label, rect});
        taken.push_back(rect);
    };
    const auto seek = [&](const SceneLabel& label) {
        const TextSize size = measure(label);
        if (label.fixed) {
            const ScreenRect rect{label.at.x, label.at.y - size.height / 2, size.width,
                                  size.height};
            if (isFree(rect)) {
                put(label, rect);
            }
            return;
        }
        for (const double reach : {label.clearance, 1.8 * label.clearance}) {
            for (const auto& direction : directions) {
                const auto rect = rectToward(label, size, direction, reach);
                if (isFree(rect)) {
                    return put(label, rect);
                }
            }
        }
        const auto first = rectToward(label, size, directions.front(), label.clearance);
        const bool collides = std::ranges::any_of(
            placed, [&](const PlacedLabel& other) { return overlap(first, other.rect); });
        if (!label.optional && !collides && isInside(first, scene.frame)) {
            put(label, first);
        }
    };
    // What must be seen finds its place first, then what may be left out, then the grid's numbers.
    const auto rank = [](const SceneLabel& label) {
        return label.fixed ? 2 : label.optional ? 1 : 0;
    };
    for (const int turn : {0, 1, 2}) {
        for (const auto& label : scene.labels) {
            if (rank(label) == turn) {
                seek(label);
            }
        }
    }
    return placed;
}

} // namespace splineloft::ui
