#include "ui/canvas/outline.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace splineloft::ui {
namespace {

constexpr int mostHalvings = 18; // of one piece

/// A Bézier point on the screen, homogeneous: both coordinates times its weight, which is 1 on
/// polynomial pieces.
struct Corner {
    double x, y, weight;
    ScreenPoint place() const { return {x / weight, y / weight}; }
};

using Hull = std::vector<Corner>;

bool isOutside(const Hull& hull, const ScreenRect& frame) {
    const auto all = [&](auto test) {
        return std::ranges::all_of(hull, [&](const Corner& c) { return test(c.place()); });
    };
    return all([&](ScreenPoint p) { return p.x < frame.left - lineOverhang; }) ||
           all([&](ScreenPoint p) { return p.x > frame.right() + lineOverhang; }) ||
           all([&](ScreenPoint p) { return p.y < frame.top - lineOverhang; }) ||
           all([&](ScreenPoint p) { return p.y > frame.bottom() + lineOverhang; });
}

/// Whether the inner Bézier points are so near to their places on an evenly run line that the curve
/// is within the tolerance of the line.
/// (On rational pieces that is so as far as the weights are even, and cutting evens them quickly.)
bool isFlat(const Hull& hull) {
    const auto n = hull.size() - 1;
    const double bound = static_cast<double>(n * (n - 1)) / 8;
    for (std::size_t i = 0; i + 2 < hull.size(); ++i) {
        const auto [a, b, c] =
            std::array{hull[i].place(), hull[i + 1].place(), hull[i + 2].place()};
        const double bendX = a.x - 2 * b.x + c.x;
        const double bendY = a.y - 2 * b.y + c.y;
        const double uneven = std::max(hull[i].weight, hull[i + 1].weight) /
                              std::min(hull[i].weight, hull[i + 1].weight);
        if (uneven > 2 && std::hypot(c.x - a.x, c.y - a.y) > 1) {
            return false;
        }
        if (!(bound * std::hypot(bendX, bendY) <= lineFlatness)) {
            return false;
        }
    }
    return true;
}

/// Adds everything after the first point of the hull's curve.
void add(std::vector<ScreenPoint>& line, Hull hull, const ScreenRect& frame, int depth) {
    if (depth == mostHalvings || isFlat(hull) || isOutside(hull, frame)) {
        line.push_back(hull.back().place());
        return;
    }
    // The sides of de Casteljau's ladder at one half are the hulls of the two halves.
    Hull left;
    Hull right(hull.size());
    for (std::size_t count = hull.size(); count > 0; --count) {
        left.push_back(hull.front());
        right[count - 1] = hull[count - 1];
        for (std::size_t i = 0; i + 1 < count; ++i) {
            hull[i] = {0.5 * (hull[i].x + hull[i + 1].x), 0.5 * (hull[i].y + hull[i + 1].y),
                       0.5 * (hull[i].weight + hull[i + 1].weight)};
        }
    }
    add(line, std::move(left), frame, depth + 1);
    add(line, std::move(right), frame, depth + 1);
}

} // namespace

std::vector<ScreenPoint> outline(const Pieces& plane, const Viewport& viewport) {
    std::vector<ScreenPoint> line;
    for (std::size_t i = 0; i < plane.size(); ++i) {
        const Piece piece = plane[i];
        Hull hull;
        for (int k = 0; k <= piece.degree; ++k) {
            const Point p = piece.bezierPoint(k);
            const ScreenPoint place = viewport.toScreen({p[0], p[1]});
            const double weight = piece.weight(k);
            hull.push_back({weight * place.x, weight * place.y, weight});
        }
        if (i == 0) {
            line.push_back(hull.front().place());
        }
        add(line, std::move(hull), viewport.frame, 0);
    }
    return line;
}

} // namespace splineloft::ui
