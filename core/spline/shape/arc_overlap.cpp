// Whether two arcs run along each other. Where they do, the stretch that they share ends where one
// of the two ends (both go on along the same algebraic curve), so that it is known from the ends;
// and curves that meet in more places than the product of their degrees are one (Bézout).
#include "core/spline/algebra/scale.h"
#include "core/spline/shape/arcs.h"

#include <algorithm>
#include <cmath>

namespace splineloft {
namespace {

using Place = std::array<double, 2>;

// Shorter stretches than this, relative to the arcs, are places.
constexpr double shortest = 0x1p-26;
// Places compared, at most: high degrees do not agree by chance in so many.
constexpr int mostCompared = 64;

double distanceOf(const Place& p, const Place& q) {
    return std::hypot(q[0] - p[0], q[1] - p[1]);
}

/// Bernstein's polynomials summed up as by Horner: no room needed, and quicker than a ladder.
Place placeAt(const Arc& arc, double u, const Piece& shape) {
    const auto width = static_cast<std::size_t>(shape.width());
    std::array<double, 3> sum{};
    double factor = 1;
    for (int k = 0; k <= shape.degree; ++k) {
        const double rest = k < shape.degree ? 1 - u : 1;
        for (std::size_t c = 0; c < width; ++c) {
            const double number = arc.bezier[static_cast<std::size_t>(k) * width + c];
            sum[c] = (sum[c] + factor * number) * rest;
        }
        factor *= u * (shape.degree - k) / (k + 1);
    }
    const double weight = shape.form == Form::rational ? sum[2] : 1;
    return {sum[0] / weight, sum[1] / weight};
}

/// Where the arc passes a place within rounding, if it does. Neither x nor y turns back, so that
/// the way into the arc's own quadrant grows all along it.
std::optional<double> spotOn(const Arc& arc, const Place& place, const Piece& shape,
                             double rounding) {
    for (std::size_t c = 0; c < 2; ++c) {
        if (place[c] < arc.least[c] - rounding || place[c] > arc.greatest[c] + rounding) {
            return std::nullopt;
        }
    }
    const auto beyond = [&](double u) {
        const Place at = placeAt(arc, u, shape);
        return arc.runs[0] * (at[0] - place[0]) + arc.runs[1] * (at[1] - place[1]);
    };
    double low = 0, high = 1;
    double before = beyond(low), after = beyond(high);
    if (before >= 0 || after <= 0) {
        high = low = before >= 0 ? 0 : 1;
    }
    constexpr int mostSteps = 100;
    for (int side = 0, steps = 0; high > low && steps < mostSteps; ++steps) {
        const double u = std::clamp(low + (high - low) * before / (before - after), low, high);
        const double now = beyond(u);
        if (std::abs(now) <= 0.25 * rounding || u == low || u == high) {
            low = high = u;
        } else if (now < 0) { // the Illinois rule: an end that stays counts for half
            low = u;
            before = now;
            after *= side < 0 ? 0.5 : 1;
            side = -1;
        } else {
            high = u;
            after = now;
            before *= side > 0 ? 0.5 : 1;
            side = 1;
        }
    }
    const bool passes = distanceOf(placeAt(arc, low, shape), place) <= rounding;
    return passes ? std::optional(low) : std::nullopt;
}

/// The same Bézier points, in the other order.
bool isReversed(const Arc& a, const Arc& b, std::size_t width) {
    const std::size_t size = a.bezier.size();
    for (std::size_t i = 0; i < size; ++i) {
        if (a.bezier[i] != b.bezier[size - width - i / width * width + i % width]) {
            return false;
        }
    }
    return true;
}

/// From the first to the last of the arcs' ends that lie on both.
std::optional<Overlap> betweenEnds(const Arc& a, const Arc& b, const Piece& shape,
                                   double rounding) {
    Overlap overlap{{1, 0}, {0, 0}};
    const auto take = [&](double u, double v) {
        if (u <= overlap.a[0]) {
            overlap.a[0] = u;
            overlap.b[0] = v;
        }
        if (u >= overlap.a[1]) {
            overlap.a[1] = u;
            overlap.b[1] = v;
        }
    };
    for (const double end : {0.0, 1.0}) {
        if (const auto v = spotOn(b, placeAt(a, end, shape), shape, rounding)) {
            take(end, *v);
        }
        if (const auto u = spotOn(a, placeAt(b, end, shape), shape, rounding)) {
            take(*u, end);
        }
    }
    const bool isStretch = overlap.a[0] < overlap.a[1];
    return isStretch ? std::optional(overlap) : std::nullopt;
}

double sizeOf(const Arc& arc) {
    return std::max(arc.greatest[0] - arc.least[0], arc.greatest[1] - arc.least[1]);
}

} // namespace

std::optional<Overlap> overlapOf(const Arc& a, const Arc& b, const Piece& shape) {
    if (a.bezier == b.bezier) {
        return Overlap{{0, 1}, {0, 1}};
    }
    if (isReversed(a, b, static_cast<std::size_t>(shape.width()))) {
        return Overlap{{0, 1}, {1, 0}};
    }
    const double rounding = 4 * std::max(a.rounding, b.rounding);
    const auto overlap = betweenEnds(a, b, shape, rounding);
    if (!overlap) {
        return std::nullopt;
    }
    const auto [low, high] = overlap->a;
    const double length = distanceOf(placeAt(a, low, shape), placeAt(a, high, shape));
    if (length <= std::max(shortest * std::min(sizeOf(a), sizeOf(b)), rounding)) {
        return std::nullopt;
    }
    constexpr double golden = 0.6180339887498949; // its multiples spread evenly, however many
    const int compared = std::min(shape.degree * shape.degree + 1, mostCompared);
    for (int i = 1; i <= compared; ++i) {
        const double part = i * golden - std::floor(i * golden);
        if (!spotOn(b, placeAt(a, std::lerp(low, high, part), shape), shape, rounding)) {
            return std::nullopt;
        }
    }
    return overlap;
}

} // namespace splineloft
