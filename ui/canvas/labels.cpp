#include "ui/canvas/labels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

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

/// Whether a line from a to b touches a rectangle (Liang and Barsky 1984).
bool touches(ScreenPoint a, ScreenPoint b, const ScreenRect& rect) {
    double from = 0;
    double to = 1;
    const auto cut = [&](double way, double toLow, double toHigh) {
        if (way == 0) {
            return toLow <= 0 && toHigh >= 0;
        }
        from = std::max(from, std::min(toLow / way, toHigh / way));
        to = std::min(to, std::max(toLow / way, toHigh / way));
        return from <= to;
    };
    return cut(b.x - a.x, rect.left - a.x, rect.right() - a.x) &&
           cut(b.y - a.y, rect.top - a.y, rect.bottom() - a.y);
}

/// Lines that a name should rather not lie on.
bool isInTheWay(const SceneStroke& stroke) {
    switch (stroke.ink.role) {
    case Role::curve:
    case Role::otherCurve:
    case Role::ladder:
    case Role::handleLine:
    case Role::polygon: return true;
    default: return false;
    }
}

/// One search for places.
class Placement {
  public:
    Placement(const Scene& scene, const MeasureText& measure, double markRadius)
        : scene_(scene), measure_(measure) {
        for (const auto& mark : scene.marks) {
            taken_.push_back(
                {mark.at.x - markRadius, mark.at.y - markRadius, 2 * markRadius, 2 * markRadius});
        }
    }

    void seek(const SceneLabel& label) {
        const TextSize size = measure_(label);
        if (label.fixed) {
            const ScreenRect rect{label.at.x - label.anchor * size.width,
                                  label.at.y - size.height / 2, size.width, size.height};
            return isFree(rect) ? put(label, rect) : void();
        }
        if (const auto rect = bestRect(label, size)) {
            return put(label, *rect);
        }
        const auto first = rectToward(label, size, directions.front(), label.clearance);
        const bool collides = std::ranges::any_of(
            placed_, [&](const PlacedLabel& other) { return overlap(first, other.rect); });
        if (!label.optional && !collides && isInside(first, scene_.frame)) {
            put(label, first);
        }
    }

    std::vector<PlacedLabel> take() { return std::move(placed_); }

  private:
    bool isFree(const ScreenRect& rect) const {
        return isInside(rect, scene_.frame) && std::ranges::none_of(taken_, [&](const auto& other) {
                   return overlap(rect, other);
               });
    }

    int linesUnder(const ScreenRect& rect) const {
        int count = 0;
        for (const auto& stroke : scene_.strokes) {
            if (!isInTheWay(stroke)) {
                continue;
            }
            for (std::size_t i = 0; i + 1 < stroke.points.size(); ++i) {
                if (touches(stroke.points[i], stroke.points[i + 1], rect)) {
                    ++count;
                    break;
                }
            }
        }
        return count;
    }

    /// Of the free places around a label's point, the first of those with the fewest lines under
    /// it.
    std::optional<ScreenRect> bestRect(const SceneLabel& label, TextSize size) const {
        std::optional<ScreenRect> best;
        int fewest = 0;
        for (const double reach : {label.clearance, 1.8 * label.clearance}) {
            for (const auto& direction : directions) {
                const auto rect = rectToward(label, size, direction, reach);
                if (!isFree(rect)) {
                    continue;
                }
                const int lines = linesUnder(rect);
                if (!best || lines < fewest) {
                    best = rect;
                    fewest = lines;
                }
                if (fewest == 0) {
                    return best;
                }
            }
        }
        return best;
    }

    void put(const SceneLabel& label, const ScreenRect& rect) {
        placed_.push_back({&label, rect});
        taken_.push_back(rect);
    }

    const Scene& scene_;
    const MeasureText& measure_;
    std::vector<ScreenRect> taken_;
    std::vector<PlacedLabel> placed_;
};

/// What must be seen finds its place first, then notes, then what may be left out, then the grid's
/// numbers.
int rank(const SceneLabel& label) {
    return label.fixed ? 3 : !label.optional ? 0 : label.noted ? 1 : 2;
}

} // namespace

std::vector<PlacedLabel> placeLabels(const Scene& scene, const MeasureText& measure,
                                     double markRadius) {
    Placement placement(scene, measure, markRadius);
    for (const int turn : {0, 1, 2, 3}) {
        for (const auto& label : scene.labels) {
            if (rank(label) == turn) {
                placement.seek(label);
            }
        }
    }
    return placement.take();
}

} // namespace splineloft::ui
