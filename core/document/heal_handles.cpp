#include "core/document/handles.h"
#include "core/document/heal.h"
#include "core/spline/change/fit.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace splineloft {
namespace {

constexpr int waypointsPerPiece = 16;
constexpr int mostRounds = 40; // of matching places and fitting

/// A place that the merged piece should pass, and the parameter value at which it does so.
struct Waypoint {
    Point place;
    double u;
};

/// A piece that bridges a gap: the pieces that were there, and the ends.
struct Gap {
    std::vector<std::size_t> pieces; ///< of the old curve
    std::size_t anchor;              ///< of the new curve, at which the merged piece begins
};

/// How long each of the old pieces is in the parameter of the merged one: as it would be if the
/// anchors between them had been cut into it, where the handles on either side of an anchor have
/// the ratio of the two parts; by chord length where there are no such handles.
std::vector<double> intervalsOf(const Pieces& old, const std::vector<std::size_t>& pieces) {
    std::vector<double> intervals = {1};
    for (std::size_t k = 1; k < pieces.size(); ++k) {
        const Piece before = old[pieces[k - 1]];
        const Piece after = old[pieces[k]];
        double arriving = distance(before.bezierPoint(2), before.bezierPoint(3));
        double leaving = distance(after.bezierPoint(0), after.bezierPoint(1));
        if (!(arriving > 0 && leaving > 0)) {
            arriving = distance(before.bezierPoint(0), before.bezierPoint(3));
            leaving = distance(after.bezierPoint(0), after.bezierPoint(3));
        }
        const double ratio = arriving > 0 && leaving > 0 ? leaving / arriving : 1;
        intervals.push_back(intervals.back() * std::clamp(ratio, 1e-3, 1e3));
    }
    return intervals;
}

std::vector<Waypoint> waypointsOf(const Pieces& old, const std::vector<std::size_t>& pieces) {
    const auto intervals = intervalsOf(old, pieces);
    double whole = 0;
    for (const double interval : intervals) {
        whole += interval;
    }
    std::vector<Waypoint> waypoints;
    double start = 0;
    for (std::size_t k = 0; k < pieces.size(); ++k) {
        for (int i = k == 0 ? 1 : 0; i < waypointsPerPiece; ++i) {
            const double u = static_cast<double>(i) / waypointsPerPiece;
            waypoints.push_back({old.position({pieces[k], u}), (start + u * intervals[k]) / whole});
        }
        start += intervals[k];
    }
    return waypoints;
}

/// The direction from an end of a piece, past Bézier points that lie on it.
Point directionFrom(const Piece& piece, bool fromEnd) {
    const auto point = [&](int i) { return piece.bezierPoint(fromEnd ? piece.degree - i : i); };
    for (int i = 1; i <= piece.degree; ++i) {
        const Point way = point(i) - point(0);
        if (norm(way) > 0) {
            return (1 / norm(way)) * way;
        }
    }
    return Point(piece.dimension);
}

/// A cubic between two ends of which the directions are known.
struct Merged {
    Point start, startDirection, end, endDirection;
    double startReach = 0, endReach = 0;

    std::array<Point, 4> points() const {
        return {start, start + startReach * startDirection, end + endReach * endDirection, end};
    }
};

std::optional<Merged> fitted(Merged merged, const std::vector<Waypoint>& waypoints) {
    std::vector<conversion::Row> rows;
    for (const auto& [place, u] : waypoints) {
        const double v = 1 - u;
        const double first = 3 * v * v * u;
        const double second = 3 * v * u * u;
        rows.push_back(
            {first * merged.startDirection, second * merged.endDirection,
             place - (v * v * v + first) * merged.start - (u * u * u + second) * merged.end});
    }
    const auto reaches = conversion::fitTwo(rows);
    if (!reaches || !(reaches->x > 0) || !(reaches->y > 0)) {
        return std::nullopt;
    }
    merged.startReach = reaches->x;
    merged.endReach = reaches->y;
    return merged;
}

double squaresOf(const Merged& merged, const std::vector<Waypoint>& waypoints) {
    const auto p = merged.points();
    double sum = 0;
    for (const auto& [place, u] : waypoints) {
        const Point off = Ladder<Point>(p, u).tip() - place;
        sum += dot(off, off);
    }
    return sum;
}

/// Lets each sample be met where the cubic is nearest to it: one step of Newton's.
void match(const Merged& merged, std::vector<Waypoint>& waypoints) {
    const auto p = merged.points();
    for (auto& [place, u] : waypoints) {
        const auto ladder = Ladder<Point>(p, u);
        const Point off = ladder.tip() - place;
        const Point first = 3.0 * (ladder.level(2)[1] - ladder.level(2)[0]);
        const Point second =
            6.0 * (ladder.level(1)[2] - 2.0 * ladder.level(1)[1] + ladder.level(1)[0]);
        const double slope = dot(first, first) + dot(off, second);
        if (slope > 0) {
            u = std::clamp(u - dot(off, first) / slope, 0.0, 1.0);
        }
    }
}

std::optional<Merged> nearestTo(const Merged& ends, std::vector<Waypoint> waypoints) {
    auto best = fitted(ends, waypoints);
    if (!best) {
        return std::nullopt;
    }
    double least = squaresOf(*best, waypoints);
    for (int round = 0; round < mostRounds; ++round) {
        match(*best, waypoints);
        const auto next = fitted(ends, waypoints);
        const double squares = next ? squaresOf(*next, waypoints) : least;
        if (!(squares < least * (1 - 1e-6))) {
            break;
        }
        best = next;
        least = squares;
    }
    return best;
}

/// Gaps between anchors that pieces begin or end at; points beyond the last of these bound none.
std::vector<Gap> gapsOf(const Curve& old, std::size_t pieces, const std::set<std::size_t>& gone) {
    const auto anchors = old.closed ? pieces : pieces + 1;
    std::vector<std::size_t> kept;
    for (std::size_t k = 0; k < anchors; ++k) {
        if (!gone.contains(3 * k)) {
            kept.push_back(k);
        }
    }
    std::vector<Gap> gaps;
    for (std::size_t i = 0; i + (old.closed ? 0 : 1) < kept.size(); ++i) {
        const auto next = i + 1 < kept.size() ? kept[i + 1] : kept[0] + anchors;
        if (next - kept[i] > 1) {
            gaps.push_back({{}, 3 * i});
            for (auto piece = kept[i]; piece < next; ++piece) {
                gaps.back().pieces.push_back(piece % pieces);
            }
        }
    }
    return gaps;
}

} // namespace

CurveEntry withFittedHandles(const Curve& old, const CurveEntry& left,
                             const std::set<std::size_t>& gone) {
    const Pieces pieces = piecesOf(old);
    auto curve = std::make_shared<Curve>(*left);
    CurveEntry result = left;
    for (const auto& [merged, anchor] : gapsOf(old, pieces.size(), gone)) {
        const Piece first = pieces[merged.front()];
        const Piece last = pieces[merged.back()];
        const Merged ends = {first.bezierPoint(0), directionFrom(first, false), last.bezierPoint(3),
                             directionFrom(last, true)};
        if (const auto found = nearestTo(ends, waypointsOf(pieces, merged))) {
            curve->points.set(anchor + 1, found->points()[1]);
            curve->points.set(anchor + 2, found->points()[2]);
            result.handleModes.erase(anchor);
            result.handleModes.erase(anchorAfter(*curve, anchor).value_or(anchor));
        }
    }
    result = std::move(curve);
    return result;
}

} // namespace splineloft
