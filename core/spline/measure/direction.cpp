#include "core/spline/measure/direction.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace splineloft {
namespace {

/// What rounding of the Bézier points leaves of a difference.
double roundingOf(const Piece& piece) {
    double farthest = 0;
    for (int k = 0; k <= piece.degree; ++k) {
        farthest = std::max(farthest, norm(piece.bezierPoint(k)));
    }
    return 64 * std::numeric_limits<double>::epsilon() * farthest;
}

/// The limit of the direction from one side of u.
std::optional<Point> limitAt(const Piece& piece, double u, double rounding) {
    const auto ladder = piece.ladder(u);
    const bool ahead = u <= 0.5;
    for (int level = piece.degree - 1; level >= 0; --level) {
        const auto rungs = ladder.level(level);
        const Point way = ahead ? rungs.back() - ladder.tip() : ladder.tip() - rungs.front();
        if (norm(way) > rounding) {
            return directionOf(way);
        }
    }
    return std::nullopt;
}

} // namespace

std::optional<Point> directionOf(const Point& vector) {
    const double length = norm(vector);
    if (!(length > 0) || !std::isfinite(length)) {
        return std::nullopt;
    }
    const Point unit = unitVector(vector);
    return (1 / norm(unit)) * unit; // to the last bit
}

std::optional<Point> tangentAt(const Piece& piece, double u) {
    constexpr double clearly = 1e3; // times rounding
    const double rounding = roundingOf(piece);
    const Point first = piece.jet(u).first;
    if (norm(first) > clearly * rounding) {
        return directionOf(first);
    }
    return limitAt(piece, u, rounding);
}

} // namespace splineloft
