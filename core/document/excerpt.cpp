#include "core/document/excerpt.h"

#include "core/spline/arrangement.h"
#include "core/spline/change/convert.h"
#include "core/spline/change/knots.h"
#include "core/spline/change/shape.h"
#include "core/spline/problem.h"

#include <algorithm>

namespace splineloft {
namespace {

/// Pieces of a row, around its end and on from its beginning.
Pieces cyclic(const Pieces& pieces, std::size_t first, std::size_t count) {
    std::vector<double> bezier;
    std::vector<double> knots = {0};
    for (std::size_t i = 0; i < count; ++i) {
        const auto own = pieces[(first + i) % pieces.size()].coordinates;
        bezier.insert(bezier.end(), own.begin(), own.end());
        knots.push_back(static_cast<double>(i + 1));
    }
    return {pieces.degree(), pieces.dimension(), KnotLine(std::move(knots)), std::move(bezier),
            pieces.form()};
}

/// Whether the curve is these pieces.
bool draws(const Curve& curve, const Pieces& pieces) {
    if (problemOf(curve)) {
        return false;
    }
    const auto difference = differenceOf(pieces, piecesOf(curve));
    return difference && difference->most <= conversion::toleranceOf(pieces);
}

/// What the pieces of a curve read, by number among the arranged places; of a closed curve around
/// and around.
class Reading {
  public:
    Reading(const Curve& curve, const Arrangement& arrangement)
        : curve_(curve), arrangement_(arrangement) {
        const auto stride = static_cast<std::size_t>(arrangement.layout.stride);
        ring_ = curve.closed ? curve.points.size() / stride * stride : 0;
    }

    const Place& place(std::size_t at) const {
        return arrangement_.places[ring_ > 0 ? at % ring_ : at];
    }
    double knot(std::size_t at) const {
        const auto& knots = arrangement_.knots;
        if (ring_ == 0) {
            return knots[at];
        }
        const double period = curve_.knots.back() - curve_.knots.front();
        return knots[at % ring_] + static_cast<double>(at / ring_) * period;
    }
    /// Where the window of a piece begins, also of those after the last of a closed curve.
    std::size_t window(std::size_t piece) const {
        const auto pieces = arrangement_.pieces();
        return arrangement_.windows[piece % pieces] + piece / pieces * ring_;
    }

  private:
    const Curve& curve_;
    const Arrangement& arrangement_;
    std::size_t ring_ = 0; ///< places of one turn; 0 where the curve is open
};

/// A curve like this one without points and lists, open.
Curve blankOf(const Curve& curve) {
    Curve blank = curve;
    blank.closed = false;
    const auto& accepted = familyOf(curve).ends;
    const bool mayBeOpen = std::ranges::find(accepted, Ends::open) != accepted.end();
    blank.ends = !familyOf(curve).usesKnots && mayBeOpen ? Ends::open : Ends::none;
    blank.points = Points(curve.points.dimension());
    blank.tangents = Points(curve.points.dimension());
    blank.weights.clear();
    blank.knots.clear();
    for (auto& [key, values] : blank.local) {
        values.clear();
    }
    return blank;
}

void append(Curve& result, const Curve& from, const Place& place) {
    const Point own = from.points.at(place.control);
    result.points.append(place.mirroredAt ? 2.0 * from.points.at(*place.mirroredAt) - own : own);
    if (!from.tangents.empty()) {
        result.tangents.append(from.tangents.at(place.control));
    }
    if (!from.weights.empty()) {
        result.weights.push_back(from.weights[place.control]);
    }
    for (auto& [key, values] : result.local) {
        values.push_back(from.local.at(key)[place.control]);
    }
}

/// The control points that stand before the knot `start` and after the knot `end` go.
Curve trimmed(const Curve& curve, double start, double end) {
    const auto& knots = curve.knots;
    const auto before =
        static_cast<std::size_t>(std::ranges::lower_bound(knots, start) - knots.begin());
    const auto after = static_cast<std::size_t>(knots.end() - std::ranges::upper_bound(knots, end));
    Curve result = blankOf(curve);
    for (auto i = before; i + after < curve.points.size(); ++i) {
        append(result, curve, {i, std::nullopt});
    }
    result.knots.assign(knots.begin() + static_cast<std::ptrdiff_t>(before),
                        knots.end() - static_cast<std::ptrdiff_t>(after));
    return result;
}

std::optional<Curve> withKnots(const Curve& curve, double at, std::size_t times) {
    const auto standing = static_cast<std::size_t>(std::ranges::count(curve.knots, at));
    if (standing >= times) {
        return curve;
    }
    const auto result = withKnot(curve, at, static_cast<int>(times - standing));
    const auto* more = std::get_if<Curve>(&result);
    return more == nullptr ? std::nullopt : std::optional(*more);
}

} // namespace

std::optional<Curve> excerpt(const Curve& curve, std::size_t first, std::size_t count) {
    Curve whole = curve;
    const bool usesKnots = familyOf(curve).usesKnots;
    if (usesKnots) {
        const auto own = withOwnKnots(curve);
        if (std::holds_alternative<Problem>(own)) {
            return std::nullopt;
        }
        whole = std::get<Curve>(own);
    }
    const auto arrangement = arrangementOf(whole, whole.points);
    const Reading reading(whole, arrangement);
    const auto begin = reading.window(first);
    const auto end =
        reading.window(first + count - 1) + static_cast<std::size_t>(arrangement.layout.window);
    Curve result = blankOf(whole);
    for (auto at = begin; at < end; ++at) {
        append(result, whole, reading.place(at));
    }
    const auto degree = static_cast<std::size_t>(arrangement.layout.degree);
    for (auto at = begin; usesKnots && at < end + degree + 1; ++at) {
        result.knots.push_back(reading.knot(at));
    }
    return draws(result, cyclic(piecesOf(curve), first, count)) ? std::optional(result)
                                                                : std::nullopt;
}

std::optional<Curve> clampedAtEnds(const Curve& curve) {
    const auto own = withOwnKnots(curve);
    const auto* written = std::get_if<Curve>(&own);
    if (written == nullptr) {
        return std::nullopt;
    }
    const Pieces pieces = piecesOf(*written);
    if (pieces.empty()) {
        return std::nullopt;
    }
    const auto times = static_cast<std::size_t>(pieces.degree()) + 1;
    const double start = pieces.knots().start();
    const double end = pieces.knots().end();
    auto result = withKnots(*written, start, times);
    result = result ? withKnots(*result, end, times) : std::nullopt;
    result = result ? std::optional(trimmed(*result, start, end)) : std::nullopt;
    return result && draws(*result, pieces) ? result : std::nullopt;
}

} // namespace splineloft
