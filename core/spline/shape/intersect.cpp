#include "core/spline/shape/intersect.h"

#include "core/spline/algebra/rounded.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace splineloft {
namespace {

// Zeros this close in u, one on each side of a joint, are both the joint.
constexpr double closeToJoint = 1e-12;

/// The largest number without its sign.
double largestOf(const Point& p) {
    double largest = 0;
    for (const double x : p.coordinates()) {
        largest = std::max(largest, std::abs(x));
    }
    return largest;
}

/// The way from one place to another, divided by some positive number so that it cannot overflow.
Point scaledWay(const Point& a, const Point& b) {
    Point way = 0.5 * b - 0.5 * a;
    const double largest = largestOf(way);
    int exponent = 0;
    std::frexp(largest, &exponent);
    for (int c = 0; c < way.dimension() && std::isfinite(largest); ++c) {
        way[c] = std::ldexp(way[c], -exponent);
    }
    return way;
}

/// The distance from the hyperplane along a piece, in some unit.
Rounded distanceOf(const Piece& piece, const Hyperplane& hyperplane) {
    const LocalPiece local = localPiece(piece, hyperplane.place);
    Rounded distance;
    for (int c = 0; c < piece.dimension; ++c) {
        Rounded share = local.coordinates[static_cast<std::size_t>(c)];
        for (double& x : share.coefficients) {
            x *= hyperplane.normal[c];
        }
        share.rounding *= std::abs(hyperplane.normal[c]);
        distance = c == 0 ? share : sum(distance, share);
    }
    return distance;
}

/// Whether a curve is at the same place at two spots, within the rounding of its coordinates.
bool samePlace(const Pieces& pieces, Spot a, Spot b) {
    const Point first = pieces.position(a);
    const Point second = pieces.position(b);
    const double largest = std::max(largestOf(first), largestOf(second));
    return largestOf(first - second) <= 64 * std::numeric_limits<double>::epsilon() * largest;
}

/// Adds a spot of the next piece, or of the same one. At a joint, the later piece's spot stays.
void add(std::vector<Spot>& spots, const Pieces& pieces, Spot spot) {
    const bool opens = spot.u <= closeToJoint;
    if (opens && !spots.empty() && spots.back().segment + 1 == spot.segment &&
        spots.back().u >= 1 - closeToJoint &&
        samePlace(pieces, {spot.segment - 1, 1}, {spot.segment, 0})) {
        spots.pop_back();
        spot.u = 0;
    }
    spots.push_back(spot);
}

} // namespace

std::optional<Hyperplane> lineThrough(const Point& a, const Point& b) {
    if (a.dimension() != 2 || b.dimension() != 2) {
        return std::nullopt;
    }
    const Point way = scaledWay(a, b);
    const double length = norm(way);
    if (!(length > 0) || !std::isfinite(length)) {
        return std::nullopt;
    }
    return Hyperplane{a, {-way[1] / length, way[0] / length}};
}

Crossings crossings(const Pieces& pieces, const Hyperplane& hyperplane) {
    const double size = largestOf(hyperplane.normal);
    if (pieces.empty() || hyperplane.place.dimension() != pieces.dimension() ||
        hyperplane.normal.dimension() != pieces.dimension() || !(size > 0) ||
        !std::isfinite(norm(hyperplane.normal)) || !std::isfinite(norm(hyperplane.place))) {
        return {};
    }
    const Hyperplane own{hyperplane.place, scaledWay(Point(pieces.dimension()), hyperplane.normal)};
    Crossings found;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const Rounded distance = distanceOf(pieces[i], own);
        if (distance.isZero()) {
            found.within.push_back(i);
            continue;
        }
        for (const double u : distance.roots()) {
            add(found.spots, pieces, {i, u});
        }
    }
    const Spot end{pieces.size() - 1, 1};
    auto& spots = found.spots;
    if (spots.size() > 1 && spots.front().segment == 0 && spots.front().u <= closeToJoint &&
        spots.back().segment == end.segment && spots.back().u >= 1 - closeToJoint &&
        samePlace(pieces, {0, 0}, end)) {
        spots.pop_back();
    }
    return found;
}

} // namespace splineloft
