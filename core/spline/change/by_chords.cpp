// Catmull-Rom and natural splines: through the joints, with intervals of the parameter that go with
// a power of the chords. Both are smooth by t, so the speeds by u on the two sides of a joint are
// to each other as the intervals there, and give the power away.
#include "core/spline/catalog.h"
#include "core/spline/change/fit.h"
#include "core/spline/change/proposers.h"

#include <algorithm>
#include <cmath>

namespace splineloft::conversion {
namespace {

/// The alpha with which log(ratio of intervals) = alpha log(ratio of chords) at the joints.
std::optional<double> measuredAlpha(const Shape& shape) {
    double square = 0, product = 0;
    const auto count = shape.joints();
    for (std::size_t i = 0; i < count; ++i) {
        if (!shape.isInner(i)) {
            continue;
        }
        const double before = distance(shape.joint(i), shape.joint((i + count - 1) % count));
        const double after = distance(shape.joint(i), shape.joint((i + 1) % count));
        const Point arriving = shape.arriving(i);
        const auto speeds =
            fitOne({{arriving, Point(arriving.dimension()), shape.leaving(i)}}, shape.tolerance);
        if (before > shape.tolerance && after > shape.tolerance && speeds && *speeds > 0) {
            square += std::pow(std::log(after / before), 2);
            product += std::log(after / before) * std::log(*speeds);
        }
    }
    return square > 0 ? std::optional(product / square) : std::nullopt;
}

/// Values of alpha to try, the measured one first.
std::vector<double> likelyAlphas(const Shape& shape, const Spline& spline) {
    std::vector<double> alphas;
    if (const auto alpha = measuredAlpha(shape)) {
        const double tidy = tidied(*alpha, spline, "alpha");
        if (tidy >= 0 && tidy <= 1) {
            alphas.push_back(tidy);
        }
    }
    for (const double usual : {parameterOf(spline, "alpha"), 0.0, 0.5, 1.0}) {
        if (std::ranges::find(alphas, usual) == alphas.end()) {
            alphas.push_back(usual);
        }
    }
    return alphas;
}

Curve throughJoints(const Shape& shape, const Trial& trial) {
    Curve curve = trial.blank();
    for (std::size_t i = 0; i < shape.joints(); ++i) {
        curve.points.append(shape.joint(i));
    }
    return curve;
}

/// Where `side` crosses zero between two arguments at which its signs differ.
template <class Side> double bisected(Side side, double low, double high) {
    const bool positive = side(low) > 0;
    for (double middle = lerp(low, high, 0.5); middle > low && middle < high;
         middle = lerp(low, high, 0.5)) {
        ((side(middle) > 0) == positive ? low : high) = middle;
    }
    return low;
}

/// Where |side| is least between two arguments.
template <class Side> double leastBetween(Side side, double low, double high) {
    constexpr int rounds = 60; // each leaves two thirds
    for (int round = 0; round < rounds; ++round) {
        const double third = lerp(low, high, 1.0 / 3);
        const double other = lerp(low, high, 2.0 / 3);
        (std::abs(side(third)) < std::abs(side(other)) ? high : low) =
            std::abs(side(third)) < std::abs(side(other)) ? other : third;
    }
    return lerp(low, high, 0.5);
}

/// Where `side` crosses zero among powers of 2, or comes as near as `touch`; the one nearest to 1.
template <class Side> std::optional<double> crossing(Side side, double touch) {
    constexpr double farthestPower = 40; // beyond it no knot is left to be told from its neighbour
    constexpr double step = 0.125;
    const auto atPower = [&](double power) { return side(std::exp2(power)); };
    std::optional<double> nearest;
    const auto found = [&](double power) {
        nearest = !nearest || std::abs(power) < std::abs(*nearest) ? power : *nearest;
    };
    double before = atPower(-farthestPower - step);
    double here = atPower(-farthestPower);
    for (double power = -farthestPower; power < farthestPower; power += step) {
        const double after = atPower(power + step);
        if ((here > 0) != (after > 0)) {
            found(bisected(atPower, power, power + step));
        } else if (std::abs(here) <= std::abs(before) && std::abs(here) <= std::abs(after)) {
            // Two crossings may lie close together, or be one.
            const double least = leastBetween(atPower, power - step, power + step);
            if ((atPower(least) > 0) != (here > 0)) {
                found(bisected(atPower, power - step, least));
                found(bisected(atPower, least, power + step));
            } else if (std::abs(atPower(least)) <= touch) {
                found(least);
            }
        }
        before = here;
        here = after;
    }
    return nearest ? std::optional(std::exp2(*nearest)) : std::nullopt;
}

/// The point beyond an open end that gives a piece its tangent there. With the interval beyond s
/// times that of the piece, the parabola through the three asks for the chord
/// s (tangent + s (tangent - chord)), whose length must be what spaces the knots so.
std::optional<Point> pointBeyond(const Point& end, const Point& chord, const Point& tangent,
                                 double alpha, double tolerance) {
    const auto beyond = [&](double s) { return s * (tangent + s * (tangent - chord)); };
    const auto excess = [&](double s) {
        return norm(tangent + s * (tangent - chord)) - std::pow(s, 1 / alpha - 1) * norm(chord);
    };
    // Alpha 0, and points on one line at alpha 1, which may have any interval beyond.
    if (alpha == 0 || std::abs(excess(1)) <= tolerance) {
        return end - beyond(1);
    }
    const auto s = crossing(excess, tolerance);
    return s ? std::optional(end - beyond(*s)) : std::nullopt;
}

/// The points with one more at either end, if there are such.
std::optional<Curve> withOpenEnds(const Shape& shape, Curve curve, double alpha) {
    const auto last = shape.size();
    const auto before = pointBeyond(shape.joint(0), shape.joint(1) - shape.joint(0),
                                    shape.leaving(0), alpha, shape.tolerance);
    const auto after = pointBeyond(shape.joint(last), shape.joint(last - 1) - shape.joint(last),
                                   -1.0 * shape.arriving(last), alpha, shape.tolerance);
    if (!before || !after) {
        return std::nullopt;
    }
    curve.ends = Ends::open;
    curve.points.insert(0, *before);
    curve.points.append(*after);
    return curve;
}

} // namespace

void proposeCatmullRom(const Shape& shape, Trial& trial) {
    Curve curve = throughJoints(shape, trial);
    for (const double alpha : likelyAlphas(shape, curve)) {
        curve.parameters["alpha"] = alpha;
        if (shape.closed) {
            if (trial.offer(curve)) {
                return;
            }
            continue;
        }
        for (const Ends ends : {Ends::doubled, Ends::reflected}) {
            curve.ends = ends;
            if (trial.offer(curve)) {
                return;
            }
        }
        if (const auto open = withOpenEnds(shape, curve, alpha); open && trial.offer(*open)) {
            return;
        }
    }
}

void proposeNatural(const Shape& shape, Trial& trial) {
    Curve curve = throughJoints(shape, trial);
    for (const double alpha : likelyAlphas(shape, curve)) {
        curve.parameters["alpha"] = alpha;
        if (trial.offer(curve)) {
            return;
        }
    }
}

} // namespace splineloft::conversion
