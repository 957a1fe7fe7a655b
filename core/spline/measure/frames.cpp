#include "core/spline/measure/frames.h"

#include "core/spline/measure/direction.h"

#include <algorithm>
#include <cmath>

namespace splineloft {
namespace {

constexpr int space = 3;

// A step turns the tangent by no more than about this: the error of a whole turn is below 1e-7.
constexpr double leastCosine = 0.998; // of 0.06 radians
constexpr int mostHalvings = 10;      // of one piece

Point cross(const Point& a, const Point& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// The mirror image of a vector in the plane square to a unit vector.
Point mirrored(const Point& vector, const Point& unit) {
    return vector - 2 * dot(vector, unit) * unit;
}

/// A unit vector square to a tangent, to its left where the tangent is level.
Point normalTo(const Point& tangent) {
    int least = space - 1; // the axis to which the tangent is squarest, the last one by preference
    for (const int axis : {1, 0}) {
        if (std::abs(tangent[axis]) < std::abs(tangent[least]) - 1e-9) {
            least = axis;
        }
    }
    Point up(space);
    up[least] = 1;
    return *directionOf(cross(up, tangent));
}

/// A normal without what rounding has put along the tangent.
Point squared(const Point& normal, const Point& tangent) {
    const auto clean = directionOf(normal - dot(normal, tangent) * tangent);
    return clean ? *clean : normalTo(tangent);
}

/// The normal after the least rotation that takes one tangent to another; as it is where they are
/// opposite. (It is two reflections: the first reverses `from`.)
Point turned(const Point& normal, const Point& from, const Point& to) {
    const Point middle = from + to;
    if (norm(middle) < 1e-9) {
        return squared(normal, to);
    }
    return squared(mirrored(mirrored(normal, from), *directionOf(middle)), to);
}

/// Double reflection: the first in the plane between the two places, the second brings the tangent
/// to where it belongs.
Point carried(const Point& normal, const Point& from, const Point& to, const Point& way) {
    const auto between = directionOf(way);
    if (!between) {
        return turned(normal, from, to);
    }
    const Point rest = to - mirrored(from, *between);
    const auto second = directionOf(rest);
    if (!second || norm(rest) < 1e-6) { // they nearly cancel
        return turned(normal, from, to);
    }
    return squared(mirrored(mirrored(normal, *between), *second), to);
}

Point rotated(const Point& normal, const Point& tangent, double angle) {
    return squared(std::cos(angle) * normal + std::sin(angle) * cross(tangent, normal), tangent);
}

/// For each piece the last one up to it that moves; where there is none, the first that does.
std::vector<std::size_t> movingUpTo(const Pieces& pieces) {
    const auto moves = [&](std::size_t i) { return tangentAt(pieces[i], 0).has_value(); };
    std::size_t last = 0;
    while (last < pieces.size() && !moves(last)) {
        ++last;
    }
    last = last < pieces.size() ? last : 0;
    std::vector<std::size_t> moving(pieces.size());
    for (std::size_t i = 0; i < moving.size(); ++i) {
        last = i > last && moves(i) ? i : last;
        moving[i] = last;
    }
    return moving;
}

Point axis(int dimension) {
    Point first(dimension);
    first[0] = 1;
    return first;
}

} // namespace

Frames::Frames(const Pieces& pieces, const ArcLength& lengths, bool closed)
    : pieces_(&pieces), lengths_(&lengths), moving_(movingUpTo(pieces)) {
    if (pieces.empty() || pieces.dimension() != space) {
        return;
    }
    const Point tangent = startTangent();
    const Node start{0, tangent, normalTo(tangent)};
    Node at = start;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const Point next = tangentOn(i, 0, at.tangent);
        at = {0, next, turned(at.normal, at.tangent, next)};
        first_.push_back(u_.size());
        keep(at);
        if (moving_[i] == i) {
            walk(i, at, 0.5, 1);
            walk(i, at, 1, 1);
        }
    }
    first_.push_back(u_.size());
    twist_ = closed ? twistAround(start, at) : 0;
}

void Frames::keep(const Node& node) {
    u_.push_back(node.u);
    tangents_.append(node.tangent);
    normals_.append(node.normal);
}

Frames::Node Frames::kept(std::size_t index) const {
    return {u_[index], tangents_.at(index), normals_.at(index)};
}

/// Goes on to `end` in steps that turn little, and leaves a node at each.
void Frames::walk(std::size_t segment, Node& at, double end, int depth) {
    const Node next = stepped(at, segment, end);
    const double middle = 0.5 * (at.u + end);
    const Point between = tangentOn(segment, middle, at.tangent);
    const bool bends =
        dot(at.tangent, between) < leastCosine || dot(between, next.tangent) < leastCosine;
    if (bends && depth < mostHalvings) {
        walk(segment, at, middle, depth + 1);
        walk(segment, at, end, depth + 1);
        return;
    }
    at = next;
    keep(at);
}

Frames::Node Frames::stepped(const Node& from, std::size_t segment, double u) const {
    const Point way = pieces_->position({segment, u}) - pieces_->position({segment, from.u});
    const Point tangent = tangentOn(segment, u, from.tangent);
    return {u, tangent, carried(from.normal, from.tangent, tangent, way)};
}

Point Frames::tangentOn(std::size_t segment, double u, const Point& otherwise) const {
    if (moving_[segment] != segment) {
        return otherwise;
    }
    return tangentAt((*pieces_)[segment], u).value_or(otherwise);
}

Point Frames::startTangent() const {
    const auto tangent = tangentAt((*pieces_)[moving_.front()], 0);
    return tangent.value_or(axis(pieces_->dimension()));
}

/// How far a frame that has gone all around is turned against the first.
double Frames::twistAround(const Node& start, const Node& last) {
    const Point back = turned(last.normal, last.tangent, start.tangent);
    return std::atan2(dot(back, cross(start.tangent, start.normal)), dot(back, start.normal));
}

Frame Frames::at(Spot spot) const {
    const int dimension = pieces_->dimension();
    const Point place = pieces_->position(spot);
    if (dimension != space) {
        const auto own = moving_[spot.segment];
        const double u = own == spot.segment ? spot.u : own < spot.segment ? 1 : 0;
        const Point tangent = tangentAt((*pieces_)[own], u).value_or(axis(dimension));
        Frame frame{place, tangent, {}};
        if (dimension == 2) {
            frame.normals.push_back({-tangent[1], tangent[0]});
        }
        return frame;
    }
    const auto begin = u_.begin() + static_cast<std::ptrdiff_t>(first_[spot.segment]);
    const auto end = u_.begin() + static_cast<std::ptrdiff_t>(first_[spot.segment + 1]);
    const auto after = std::upper_bound(begin + 1, end, spot.u);
    const Node before = kept(static_cast<std::size_t>(after - 1 - u_.begin()));
    const Node here = spot.u == before.u ? before : stepped(before, spot.segment, spot.u);
    const double total = lengths_->total();
    const double part = twist_ != 0 && total > 0 ? lengths_->upTo(spot) / total : 0;
    const Point normal = rotated(here.normal, here.tangent, -twist_ * part);
    return {place, here.tangent, {normal, cross(here.tangent, normal)}};
}

} // namespace splineloft
