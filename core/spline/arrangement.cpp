#include "core/spline/arrangement.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace splineloft {
namespace {

/// Once around: the `lead` last points, all points, and as many of the first as the last piece
/// needs.
std::vector<Place> aroundTheLoop(std::size_t points, std::size_t pieces, const Layout& layout) {
    std::vector<Place> places;
    const auto lead = static_cast<std::size_t>(layout.lead);
    const auto count = (pieces - 1) * static_cast<std::size_t>(layout.stride) +
                       static_cast<std::size_t>(layout.window);
    const std::size_t ring = pieces * static_cast<std::size_t>(layout.stride);
    for (std::size_t i = 0; i < count; ++i) {
        places.push_back({(i + ring * points - lead) % ring, std::nullopt});
    }
    return places;
}

/// From the first point to the last, with `extra` places added at either end.
std::vector<Place> endToEnd(std::size_t points, std::size_t extra, Ends ends) {
    std::vector<Place> places;
    const auto last = points - 1;
    const auto added = [&](std::size_t end, std::size_t inward) -> Place {
        return ends == Ends::reflected ? Place{inward, end} : Place{end, std::nullopt};
    };
    for (std::size_t k = extra; k > 0; --k) {
        places.push_back(added(0, std::min(k, last)));
    }
    for (std::size_t i = 0; i < points; ++i) {
        places.push_back({i, std::nullopt});
    }
    for (std::size_t k = 1; k <= extra; ++k) {
        places.push_back(added(last, last - std::min(k, last)));
    }
    return places;
}

/// Chord lengths to the power alpha between the arranged points. Places added at an end are spaced
/// as their mirror images are, so that a doubled end does not collapse the knots there.
std::vector<double> chordIntervals(const Curve& curve, const Arrangement& arrangement,
                                   double alpha) {
    std::vector<Point> points;
    for (const auto& place : arrangement.places) {
        const Point own = curve.points.at(place.control);
        points.push_back(place.mirroredAt ? 2.0 * curve.points.at(*place.mirroredAt) - own : own);
    }
    std::vector<double> intervals;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        intervals.push_back(std::pow(distance(points[i], points[i + 1]), alpha));
    }
    // What is below rounding beside the whole line of knots counts as nothing, as it would come out
    // anyway farther along: only near t = 0 could such a sliver survive, with huge slopes on it.
    const double whole = std::accumulate(intervals.begin(), intervals.end(), 0.0);
    const double least = std::max(std::numeric_limits<double>::epsilon() * whole,
                                  std::numeric_limits<double>::min());
    for (double& interval : intervals) {
        interval = interval < least ? 0 : interval;
    }
    if (!curve.closed) {
        const auto before = arrangement.before;
        const auto count = intervals.size();
        for (std::size_t k = 0; k < before && 2 * before <= count; ++k) {
            intervals[before - 1 - k] = intervals[before + k];
            intervals[count - before + k] = intervals[count - before - 1 - k];
        }
    }
    return intervals;
}

/// Knots that are `intervals` apart, with 0 at index `origin`.
std::vector<double> accumulate(const std::vector<double>& intervals, std::size_t origin) {
    std::vector<double> knots(intervals.size() + 1);
    for (std::size_t i = origin; i < intervals.size(); ++i) {
        knots[i + 1] = knots[i] + intervals[i];
    }
    for (std::size_t i = origin; i > 0; --i) {
        knots[i - 1] = knots[i] - intervals[i - 1];
    }
    return knots;
}

/// Whole numbers with 0 at index `origin`; with full multiplicity at both ends where clamped.
std::vector<double> wholeKnots(std::size_t count, std::size_t origin, std::size_t pieces,
                               bool clamped) {
    std::vector<double> knots;
    for (std::size_t i = 0; i < count; ++i) {
        const double knot = static_cast<double>(i) - static_cast<double>(origin);
        knots.push_back(clamped ? std::clamp(knot, 0.0, static_cast<double>(pieces)) : knot);
    }
    return knots;
}

std::vector<double> knotsOf(const Curve& curve, const Arrangement& arrangement,
                            std::size_t origin) {
    const auto count = arrangement.places.size();
    switch (familyOf(curve).spacing) {
    case Spacing::chord:
        return accumulate(chordIntervals(curve, arrangement, parametersOf(curve)[0]), origin);
    case Spacing::knotVector: {
        const auto all = count + static_cast<std::size_t>(arrangement.layout.degree) + 1;
        return wholeKnots(all, origin, arrangement.pieces,
                          !curve.closed && curve.ends == Ends::clamped);
    }
    case Spacing::uniform: break;
    }
    return wholeKnots(count, origin, arrangement.pieces, false);
}

} // namespace

Arrangement arrangementOf(const Curve& curve) {
    Arrangement result;
    result.layout = layoutOf(curve);
    const auto& layout = result.layout;
    const auto points = curve.points.size();
    const auto stride = static_cast<std::size_t>(layout.stride);
    const auto window = static_cast<std::size_t>(layout.window);
    if (points < 2) {
        return result;
    }
    if (curve.closed) {
        result.pieces = points / stride;
        result.before = static_cast<std::size_t>(layout.lead);
        if (result.pieces == 0) {
            return result;
        }
        result.places = aroundTheLoop(points, result.pieces, layout);
    } else {
        const bool extended = curve.ends == Ends::doubled || curve.ends == Ends::reflected;
        result.before = extended ? (window - 1) / 2 : 0;
        result.places = endToEnd(points, result.before, curve.ends);
        const auto count = result.places.size();
        result.pieces = count < window ? 0 : (count - window) / stride + 1;
    }
    // Piece i begins at knot origin + i: among the knots of a B-spline, or among those of the
    // points.
    const bool knotVector = familyOf(curve).spacing == Spacing::knotVector;
    const auto origin = static_cast<std::size_t>(knotVector ? layout.degree : layout.lead);
    result.knots = knotsOf(curve, result, origin);
    if (result.pieces > 0) {
        std::vector<double> joints(result.pieces + 1);
        if (stride == 1) {
            const auto first = result.knots.begin() + static_cast<std::ptrdiff_t>(origin);
            joints.assign(first, first + static_cast<std::ptrdiff_t>(result.pieces + 1));
        } else {
            std::iota(joints.begin(), joints.end(), 0.0);
        }
        result.joints = KnotLine(std::move(joints));
    }
    return result;
}

} // namespace splineloft
