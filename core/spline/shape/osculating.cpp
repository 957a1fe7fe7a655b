#include "core/spline/shape/osculating.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace splineloft {
namespace {

/// What rounding of the Bézier points can leave of a second derivative by u that is `second`.
double roundingOfSecond(const Piece& piece, const Point& second) {
    double farthest = 0, lightest = piece.weight(0), heaviest = lightest;
    for (int k = 0; k <= piece.degree; ++k) {
        const Point place = piece.bezierPoint(k);
        for (const double x : place.coordinates()) {
            farthest = std::max(farthest, std::abs(x));
        }
        lightest = std::min(lightest, piece.weight(k));
        heaviest = std::max(heaviest, piece.weight(k));
    }
    // Four terms go into a second difference; each has a rounding or two of its own, which
    // projecting enlarges by up to the ratio of the weights, twice.
    const double enlarged =
        farthest * piece.degree * piece.degree * (heaviest / lightest) * (heaviest / lightest);
    return 8 * std::numeric_limits<double>::epsilon() * std::max(enlarged, norm(second));
}

} // namespace

std::optional<OsculatingCircle> osculatingCircle(const Pieces& pieces, Spot spot) {
    if (spot.segment >= pieces.size()) {
        return std::nullopt;
    }
    const Piece piece = pieces[spot.segment];
    const Jet jet = piece.jet(spot.u);
    const double speed = norm(jet.first);
    if (!(speed >= std::numeric_limits<double>::min()) || !std::isfinite(speed)) {
        return std::nullopt;
    }
    OsculatingCircle circle;
    circle.tangent = (1 / speed) * jet.first;
    const Point aside = jet.second - dot(jet.second, circle.tangent) * circle.tangent;
    const double turning = norm(aside);
    if (!(turning > roundingOfSecond(piece, jet.second)) ||
        turning < std::numeric_limits<double>::min()) {
        return std::nullopt;
    }
    circle.normal = (1 / turning) * aside;
    circle.radius = speed * (speed / turning);
    circle.center = jet.position + circle.radius * circle.normal;
    const bool found = std::isfinite(circle.radius) && isFinite(circle.center);
    return found ? std::optional(circle) : std::nullopt;
}

} // namespace splineloft
