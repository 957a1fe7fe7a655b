#include "core/spline/arrangement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

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

/// The chord between two arranged points that follow one another, to the power alpha.
double chordAfter(const std::vector<Place>& places, std::size_t index, const PointsView& points,
                  double alpha) {
    const auto placeOf = [&](const Place& place) {
        const Point own = points.at(place.control);
        return place.mirroredAt ? 2.0 * points.at(*place.mirroredAt) - own : own;
    };
    return std::pow(norm(placeOf(places[index + 1]) - placeOf(places[index])), alpha);
}

std::vector<double> chordsOf(const std::vector<Place>& places, const PointsView& points,
                             double alpha) {
    std::vector<double> chords(places.empty() ? 0 : places.size() - 1);
    for (std::size_t i = 0; i < chords.size(); ++i) {
        chords[i] = chordAfter(places, i, points, alpha);
    }
    return chords;
}

auto at(std::vector<double>& numbers, std::size_t index) {
    return numbers.begin() + static_cast<std::ptrdiff_t>(index);
}

/// The shortest chord that counts. What is below rounding beside the whole line of knots counts as
/// nothing, as it would come out anyway farther along: only near t = 0 could such a sliver survive,
/// with huge slopes on it.
double shortestChord(std::span<const double> chords) {
    std::array<double, 4> sums{}; // of every fourth chord, so that none waits for the others
    for (std::size_t i = 0; i < chords.size(); ++i) {
        sums[i % sums.size()] += chords[i];
    }
    const double whole = (sums[0] + sums[1]) + (sums[2] + sums[3]);
    return std::max(std::numeric_limits<double>::epsilon() * whole,
                    std::numeric_limits<double>::min());
}

/// Writes the intervals that the chords give into `intervals`, as many, where so many places stand
/// `before` the first point. Places added at an end are spaced as their mirror images are, so that
/// a doubled end does not collapse the knots there. Returns which intervals were others before.
std::vector<Range> setIntervals(std::vector<double>& intervals, std::span<const double> chords,
                                bool closed, std::size_t before) {
    const double least = shortestChord(chords);
    const auto count = chords.size();
    const std::size_t mirrored = !closed && 2 * before <= count ? before : 0; // at either end
    const std::vector<double> atStart(intervals.begin(), at(intervals, mirrored));
    const std::vector<double> atEnd(at(intervals, count - mirrored), intervals.end());
    std::vector<Range> changed;
    const auto noteIf = [&](bool differs, std::size_t i) {
        if (differs) {
            changed.push_back({i, i + 1});
        }
    };
    for (std::size_t i = 0; i < count; ++i) {
        const double interval = chords[i] < least ? 0 : chords[i];
        const bool isInner = i >= mirrored && i < count - mirrored;
        noteIf(isInner && interval != intervals[i], i);
        intervals[i] = interval;
    }
    for (std::size_t k = 0; k < mirrored; ++k) {
        intervals[before - 1 - k] = intervals[before + k];
        intervals[count - before + k] = intervals[count - before - 1 - k];
    }
    for (std::size_t k = 0; k < mirrored; ++k) {
        noteIf(intervals[k] != atStart[k], k);
        noteIf(intervals[count - mirrored + k] != atEnd[k], count - mirrored + k);
    }
    return merged(std::move(changed));
}

std::vector<double> chordIntervals(std::span<const double> chords, bool closed,
                                   std::size_t before) {
    std::vector<double> intervals(chords.size());
    setIntervals(intervals, chords, closed, before);
    return intervals;
}

/// Sets knots that are `intervals` apart, with 0 at index `origin`, anew from interval `first` on,
/// and before it where it lies before the origin.
void accumulate(std::vector<double>& knots, const std::vector<double>& intervals,
                std::size_t origin, std::size_t first = 0) {
    for (std::size_t i = std::max(origin, first); i < intervals.size(); ++i) {
        knots[i + 1] = knots[i] + intervals[i];
    }
    for (std::size_t i = origin; i > 0; --i) {
        knots[i - 1] = knots[i] - intervals[i - 1];
    }
}

std::vector<double> accumulate(const std::vector<double>& intervals, std::size_t origin) {
    std::vector<double> knots(intervals.size() + 1);
    accumulate(knots, intervals, origin);
    return knots;
}

/// Whole numbers with 0 at index `origin`.
std::vector<double> wholeKnots(std::size_t count, std::size_t origin) {
    std::vector<double> knots;
    for (std::size_t i = 0; i < count; ++i) {
        knots.push_back(static_cast<double>(i) - static_cast<double>(origin));
    }
    return knots;
}

/// Intervals between a B-spline's knots from those between its places: each piece gets the leg in
/// the middle of its window, or the mean of two. Beyond the legs they go around the loop of
/// `period` pieces, or without one come mirror images.
std::vector<double> middleLegs(const std::vector<double>& legs, std::size_t degree,
                               std::size_t count, std::size_t period) {
    const auto wrapped = [](std::ptrdiff_t i, std::size_t around) {
        const auto n = static_cast<std::ptrdiff_t>(around);
        return static_cast<std::size_t>(((i % n) + n) % n);
    };
    const auto leg = [&](std::ptrdiff_t i) {
        const auto within = wrapped(i, period > 0 ? period : 2 * legs.size());
        return legs[std::min(within, 2 * legs.size() - 1 - within)];
    };
    std::vector<double> intervals;
    for (std::size_t k = 0; k < count; ++k) {
        const auto middle = static_cast<std::ptrdiff_t>(k) - static_cast<std::ptrdiff_t>(degree) +
                            static_cast<std::ptrdiff_t>(degree / 2);
        const bool odd = degree % 2 == 1;
        intervals.push_back(odd ? leg(middle) : 0.5 * (leg(middle - 1) + leg(middle)));
    }
    return intervals;
}

/// A closed B-spline's own knots, one a joint, continued around the loop: `degree` before them and
/// as many behind. Interval after interval, so that they never fall, however far apart they are.
std::vector<double> periodicKnots(const std::vector<double>& own, std::size_t degree) {
    const auto pieces = own.size() - 1;
    const auto interval = [&](std::size_t piece) { return own[piece + 1] - own[piece]; };
    std::vector<double> knots(degree);
    knots.insert(knots.end(), own.begin(), own.end());
    for (std::size_t k = 0; k < degree; ++k) {
        knots.push_back(knots.back() + interval(k % pieces));
        knots[degree - 1 - k] = knots[degree - k] - interval(pieces - 1 - k % pieces);
    }
    return knots;
}

/// A B-spline's knots, places + degree + 1 of them.
std::vector<double> knotVectorOf(const Spline& spline, const PointsView& points,
                                 const Arrangement& arrangement, double alpha) {
    const auto degree = static_cast<std::size_t>(arrangement.layout.degree);
    const auto count = arrangement.places.size() + degree + 1;
    if (!spline.knots.empty()) {
        return spline.closed ? periodicKnots(spline.knots, degree) : spline.knots;
    }
    auto knots = wholeKnots(count, degree);
    if (alpha > 0 && arrangement.places.size() > 1) {
        const auto legs = chordIntervals(chordsOf(arrangement.places, points, alpha), spline.closed,
                                         arrangement.before);
        const auto period = spline.closed ? arrangement.pieces() : 0;
        const auto spaced = accumulate(middleLegs(legs, degree, count - 1, period), degree);
        if (spaced[count - degree - 1] > spaced[degree]) { // else all points coincide
            knots = spaced;
        }
    }
    if (!spline.closed && spline.ends == Ends::clamped && count >= 2 * degree + 2) {
        const double last = knots[count - degree - 1];
        for (double& knot : knots) {
            knot = std::clamp(knot, 0.0, last);
        }
    }
    return knots;
}

void addKnots(Arrangement& arrangement, const Spline& spline, const PointsView& points) {
    switch (familyOf(spline).spacing) {
    case Spacing::chord:
        arrangement.chords = chordsOf(arrangement.places, points, parameterOf(spline, "alpha"));
        arrangement.intervals =
            chordIntervals(arrangement.chords, spline.closed, arrangement.before);
        arrangement.knots =
            accumulate(arrangement.intervals, static_cast<std::size_t>(arrangement.layout.lead));
        return;
    case Spacing::knotVector:
        arrangement.knots = knotVectorOf(spline, points, arrangement, parameterOf(spline, "alpha"));
        return;
    case Spacing::uniform:
        arrangement.knots = wholeKnots(arrangement.places.size(),
                                       static_cast<std::size_t>(arrangement.layout.lead));
        return;
    }
}

/// The parameter values at the beginnings of the windows, and where the last piece ends. Piece i
/// begins at knot origin + i, among the knots of a B-spline or among those of the points; a
/// B-spline has no piece where two of its knots are one.
void joinPieces(Arrangement& arrangement, bool knotVector) {
    const auto& layout = arrangement.layout;
    const auto& knots = arrangement.knots;
    const auto origin = static_cast<std::size_t>(knotVector ? layout.degree : layout.lead);
    if (knotVector) {
        std::erase_if(arrangement.windows, [&](std::size_t window) {
            return !(knots[origin + window] < knots[origin + window + 1]);
        });
    }
    std::vector<double> joints;
    joints.reserve(arrangement.pieces() + 1);
    for (std::size_t i = 0; i < arrangement.pieces(); ++i) {
        joints.push_back(layout.stride > 1 ? static_cast<double>(i)
                                           : knots[origin + arrangement.windows[i]]);
    }
    if (!joints.empty()) {
        joints.push_back(layout.stride > 1 ? static_cast<double>(joints.size())
                                           : knots[origin + arrangement.windows.back() + 1]);
        arrangement.joints = KnotLine(std::move(joints));
    }
}

} // namespace

Arrangement arrangementOf(const Spline& spline, const PointsView& points) {
    Arrangement result;
    result.layout = layoutOf(spline, points.size());
    const auto& layout = result.layout;
    const auto stride = static_cast<std::size_t>(layout.stride);
    const auto window = static_cast<std::size_t>(layout.window);
    if (points.size() < 2) {
        return result;
    }
    std::size_t pieces = 0;
    if (spline.closed) {
        pieces = points.size() / stride;
        result.before = static_cast<std::size_t>(layout.lead);
        if (pieces == 0) {
            return result;
        }
        result.places = aroundTheLoop(points.size(), pieces, layout);
    } else {
        const bool extended = spline.ends == Ends::doubled || spline.ends == Ends::reflected;
        result.before = extended ? (window - 1) / 2 : 0;
        result.places = endToEnd(points.size(), result.before, spline.ends);
        const auto count = result.places.size();
        pieces = count < window ? 0 : (count - window) / stride + 1;
    }
    for (std::size_t i = 0; i < pieces; ++i) {
        result.windows.push_back(i * stride);
    }
    addKnots(result, spline, points);
    joinPieces(result, familyOf(spline).spacing == Spacing::knotVector);
    return result;
}

std::vector<Range> placesOf(const Arrangement& arrangement, std::span<const Range> controls) {
    const auto& places = arrangement.places;
    const auto isPlain = [&](std::size_t place) {
        return places[place].control + arrangement.before == place && !places[place].mirroredAt;
    };
    const auto isAmong = [&](std::size_t control) {
        return std::ranges::any_of(controls, [&](const Range& range) {
            return control >= range.first && control < range.last;
        });
    };
    // From the first point to the last each stands at its own place; around them a few are added.
    const auto first = std::min(arrangement.before, places.size());
    auto last = places.size();
    while (last > first && !isPlain(last - 1)) {
        --last;
    }
    std::vector<Range> found;
    for (const auto& range : controls) {
        found.push_back({std::min(range.first + first, last), std::min(range.last + first, last)});
    }
    for (std::size_t place = 0; place < places.size(); ++place) {
        if (place == first) {
            place = last;
        }
        if (place < places.size() &&
            (isAmong(places[place].control) ||
             (places[place].mirroredAt && isAmong(*places[place].mirroredAt)))) {
            found.push_back({place, place + 1});
        }
    }
    return merged(std::move(found));
}

std::vector<Range> respace(Arrangement& arrangement, const Spline& spline, const PointsView& points,
                           std::span<const Range> moved) {
    const double alpha = parameterOf(spline, "alpha");
    for (const auto& range : moved) {
        const auto last = std::min(range.last, arrangement.chords.size());
        for (auto i = range.first > 0 ? range.first - 1 : 0; i < last; ++i) {
            arrangement.chords[i] = chordAfter(arrangement.places, i, points, alpha);
        }
    }
    auto changed =
        setIntervals(arrangement.intervals, arrangement.chords, spline.closed, arrangement.before);
    if (!changed.empty()) {
        const auto origin = static_cast<std::size_t>(arrangement.layout.lead);
        accumulate(arrangement.knots, arrangement.intervals, origin, changed.front().first);
    }
    return changed;
}

} // namespace splineloft
