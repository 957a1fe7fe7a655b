#include "core/document/heal.h"

#include "core/document/edits.h"
#include "core/document/handles.h"
#include "core/spline/measure/nearest.h"

#include <algorithm>

namespace splineloft {
namespace {

// Curves of more control points are not healed: it would take seconds.
constexpr std::size_t mostHealed = 1000;

/// The farthest that samples of `one` are from `other`.
double farthestFrom(const Pieces& one, const Pieces& other) {
    constexpr int steps = 12;
    const NearestIndex index(other);
    double farthest = 0;
    for (std::size_t i = 0; i < one.size(); ++i) {
        for (int k = 0; k <= steps; ++k) {
            const Point place = one.position({i, static_cast<double>(k) / steps});
            if (const auto nearest = index.nearest(place)) {
                farthest = std::max(farthest, nearest->distance);
            }
        }
    }
    return farthest;
}

/// How far a curve is from what it was, both ways.
double deviation(const Pieces& old, const Curve& now) {
    const Pieces pieces = piecesOf(now);
    return std::max(farthestFrom(old, pieces), farthestFrom(pieces, old));
}

/// Part of the way from the points and tangents of one curve to those of another.
Curve onTheWay(const Curve& from, const Curve& to, double part) {
    Curve result = from;
    for (std::size_t i = 0; i < from.points.size(); ++i) {
        result.points.set(i, lerp(from.points.at(i), to.points.at(i), part));
    }
    for (std::size_t i = 0; i < from.tangents.size(); ++i) {
        result.tangents.set(i, lerp(from.tangents.at(i), to.tangents.at(i), part));
    }
    return result;
}

/// The nearest to the old curve of what is left and of what it was healed to.
CurveEntry nearer(const Curve& old, const CurveEntry& left, const CurveEntry& healed) {
    const Pieces pieces = piecesOf(old);
    CurveEntry best = left;
    double least = deviation(pieces, *left);
    for (const double part : {1.0, 0.5, 0.25}) { // least squares may be farther at its farthest
        CurveEntry candidate = healed;
        candidate = std::make_shared<Curve>(onTheWay(*left, *healed, part));
        if (problemOf(Document{{candidate}, "{}"})) {
            continue;
        }
        const double here = deviation(pieces, *candidate);
        if (here < least) {
            least = here;
            best = candidate;
        }
    }
    return best;
}

CurveEntry healed(const CurveEntry& old, const CurveEntry& left,
                  const std::set<std::size_t>& gone) {
    if (old->points.size() > mostHealed || piecesOf(*left).empty()) {
        return left;
    }
    if (hasHandles(*old)) {
        return nearer(*old, left, withFittedHandles(*old, left, gone));
    }
    CurveEntry result = left;
    result = std::make_shared<Curve>(withFittedPoints(*old, *left, gone));
    return nearer(*old, left, result);
}

} // namespace

Document deleteAndHeal(const Document& document, std::span<const PointId> ids) {
    Document next = document;
    for (std::size_t i = document.curves.size(); i-- > 0;) {
        std::set<std::size_t> gone;
        std::vector<PointId> own;
        for (const auto& id : ids) {
            if (id.curve == i && id.part == Part::point) {
                gone.insert(id.index);
                own.push_back({0, id.index});
            }
        }
        if (gone.empty()) {
            continue;
        }
        const CurveEntry& old = document.curves[i];
        Document alone;
        alone.curves.push_back(old);
        const Document left = deletePoints(alone, own);
        if (left.curves.empty()) {
            next = removeCurve(next, i);
        } else {
            next.curves[i] = healed(old, left.curves[0], gone);
        }
    }
    return next;
}

} // namespace splineloft
