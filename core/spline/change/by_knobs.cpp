// Kochanek-Bartels: the control points are the joints. From how the two tangents there are shared
// out between the two chords follow tension, continuity and bias.
#include "core/spline/catalog.h"
#include "core/spline/change/corners.h"
#include "core/spline/change/fit.h"
#include "core/spline/change/proposers.h"

#include <algorithm>
#include <cmath>

namespace splineloft::conversion {
namespace {

/// Tension, continuity and bias.
struct Knobs {
    double tension = 0, continuity = 0, bias = 0;

    /// Shares of the chord before and after in the leaving tangent.
    Factors leaving() const {
        return {0.5 * (1 - tension) * (1 + continuity) * (1 + bias),
                0.5 * (1 - tension) * (1 - continuity) * (1 - bias)};
    }
    Factors arriving() const {
        return {0.5 * (1 - tension) * (1 - continuity) * (1 + bias),
                0.5 * (1 - tension) * (1 + continuity) * (1 - bias)};
    }
};

/// The knobs that share the chords out so, if any do: the products leaving.x leaving.y and
/// arriving.x arriving.y must be equal, which is left to the comparison.
Knobs knobsOf(Factors leaving, Factors arriving) {
    const double sum = leaving.x + leaving.y + arriving.x + arriving.y;
    if (sum == 0) {
        return {1, 0, 0};
    }
    return {1 - sum / 2, (leaving.x + arriving.y - leaving.y - arriving.x) / sum,
            (leaving.x + arriving.x - leaving.y - arriving.y) / sum};
}

Knobs tidied(const Knobs& knobs, const Spline& spline) {
    return {conversion::tidied(knobs.tension, spline, "tension"),
            conversion::tidied(knobs.continuity, spline, "continuity"),
            conversion::tidied(knobs.bias, spline, "bias")};
}

bool inRange(double value) {
    return std::abs(value) <= 1 + 1e-9;
}

/// With all on one line, two numbers must give three. The chords are a and b, the tangents those
/// that leave and arrive; with x = (1 - tension) (1 + bias) and y = (1 - tension) (1 - bias)
/// leaving + arriving = a x + b y and leaving - arriving = continuity (a x - b y).
/// Of the triangle x >= 0, y >= 0, x + y <= 4 the sum leaves a line, at one of whose ends the
/// difference has its longest lever; without bias is best where that will do.
std::optional<Knobs> knobsOnLine(double a, double b, double leaving, double arriving) {
    const double sum = leaving + arriving;
    const double jump = leaving - arriving;
    const double rounding = 1e-13 * std::max(std::abs(a), std::abs(b));
    if (std::max(std::abs(leaving), std::abs(arriving)) <= rounding) {
        return Knobs{1, 0, 0};
    }
    const double even = sum / (a + b);
    const double full = (sum - 4 * b) / (a - b); // x where x + y = 4
    for (const Factors& share :
         {Factors{even, even}, Factors{0, sum / b}, Factors{sum / a, 0}, Factors{full, 4 - full}}) {
        const double lever = a * share.x - b * share.y;
        const double continuity = std::abs(jump) <= rounding ? 0 : jump / lever;
        const double all = share.x + share.y;
        const Knobs knobs{1 - all / 2, continuity, (share.x - share.y) / all};
        if (all > 0 && inRange(knobs.tension) && inRange(continuity) && inRange(knobs.bias)) {
            return knobs;
        }
    }
    return std::nullopt;
}

/// The first corner of doubled ends has no chord before, so that the tangent is the chord after
/// times (1 - tension) (1 - continuity) (1 - bias) / 2; the last one turned about. 0 to 4.
Knobs knobsAtDoubled(double share, bool first) {
    if (share <= 1) {
        return {1 - 2 * share, 0, 0};
    }
    const double towardChord = first ? -1 : 1;
    return share <= 2 ? Knobs{-1, 0, towardChord * (share - 1)}
                      : Knobs{-1, 1 - share / 2, towardChord};
}

/// With reflected ends both chords are one, and the tangent is twice it times
/// (1 - tension) (1 + continuity bias) / 2. 0 to 2.
Knobs knobsAtReflected(double share) {
    const double both = std::sqrt(std::max(0.0, share - 1));
    return share <= 1 ? Knobs{1 - 2 * share, 0, 0} : Knobs{-1, both, both};
}

std::optional<Knobs> knobsAtEnd(const Corner& corner, double tolerance) {
    const Point chord = *corner.before + *corner.after;
    const bool first = corner.leaving.has_value();
    const Point& tangent = first ? *corner.leaving : *corner.arriving;
    const auto share = fitOne({{chord, Point(chord.dimension()), tangent}}, tolerance);
    if (!share) {
        return std::nullopt;
    }
    const bool doubled = norm(*corner.before) == 0 || norm(*corner.after) == 0;
    return doubled ? knobsAtDoubled(*share, first) : knobsAtReflected(*share);
}

std::optional<Knobs> knobsAt(const Corner& corner, double tolerance) {
    if (!corner.before || !corner.after) {
        return Knobs{};
    }
    const Point& a = *corner.before;
    const Point& b = *corner.after;
    if (!corner.leaving || !corner.arriving) {
        return knobsAtEnd(corner, tolerance);
    }
    if (a.dimension() > 1) { // one coordinate cannot tell the shares of two chords
        const auto leaving = fitTwo({{a, b, *corner.leaving}});
        const auto arriving = fitTwo({{a, b, *corner.arriving}});
        if (leaving && arriving) {
            return knobsOf(*leaving, *arriving);
        }
    }
    const Point& longer = norm(a) > norm(b) ? a : b;
    const double square = dot(longer, longer);
    if (!(square > tolerance * tolerance)) {
        return Knobs{};
    }
    return knobsOnLine(dot(a, longer) / square, dot(b, longer) / square,
                       dot(*corner.leaving, longer) / square,
                       dot(*corner.arriving, longer) / square);
}

/// The same knobs everywhere, from all corners at once.
std::optional<Knobs> knobsOfAll(const std::vector<Corner>& corners) {
    std::vector<Row> leaving, arriving;
    for (const auto& corner : corners) {
        if (corner.before && corner.after && corner.leaving) {
            leaving.push_back({*corner.before, *corner.after, *corner.leaving});
        }
        if (corner.before && corner.after && corner.arriving) {
            arriving.push_back({*corner.before, *corner.after, *corner.arriving});
        }
    }
    const auto out = fitTwo(leaving);
    const auto in = fitTwo(arriving);
    return out && in ? std::optional(knobsOf(*out, *in)) : std::nullopt;
}

Curve kochanekBartelsWith(const Shape& shape, const Trial& trial, Ends ends,
                          const std::vector<Knobs>& knobs) {
    return throughJoints(shape, trial, ends, [&](std::size_t end) {
        const Point at = shape.joint(end);
        const Point tangent = shape.leaving(end);
        const Factors share = end == 0 ? knobs[end].leaving() : knobs[end].arriving();
        const double inner = end == 0 ? share.y : share.x;
        const double outer = end == 0 ? share.x : share.y;
        const double away = end == 0 ? -1 : 1;
        const Point chord = away * (at - shape.joint(end == 0 ? 1 : end - 1)); // along the curve
        return outer != 0 ? at + (away / outer) * (tangent - inner * chord) : at;
    });
}

bool offerKnobs(const Shape& shape, Trial& trial, Ends ends, const Knobs& measured) {
    const Knobs knobs = tidied(measured, trial.blank());
    Curve curve =
        kochanekBartelsWith(shape, trial, ends, std::vector<Knobs>(shape.joints(), knobs));
    curve.parameters["tension"] = knobs.tension;
    curve.parameters["continuity"] = knobs.continuity;
    curve.parameters["bias"] = knobs.bias;
    return trial.offer(curve);
}

bool offerLocalKnobs(const Shape& shape, Trial& trial, Ends ends) {
    std::vector<Knobs> knobs;
    for (const auto& corner : cornersOf(shape, ends)) {
        const auto own = knobsAt(corner, shape.tolerance);
        knobs.push_back(tidied(own.value_or(Knobs{}), trial.blank()));
    }
    Curve curve = kochanekBartelsWith(shape, trial, ends, knobs);
    const auto write = [&](const char* key, double Knobs::* member) {
        std::vector<double> values;
        std::ranges::transform(knobs, std::back_inserter(values), member);
        curve.local[key] = atPoints(values, curve, 0);
    };
    write("tension", &Knobs::tension);
    write("continuity", &Knobs::continuity);
    write("bias", &Knobs::bias);
    return trial.offer(curve);
}

} // namespace

void proposeKochanekBartels(const Shape& shape, Trial& trial) {
    for (const Ends ends : waysToEnd(shape)) {
        const auto corners = cornersOf(shape, ends);
        if (const auto all = knobsOfAll(corners); all && offerKnobs(shape, trial, ends, *all)) {
            return;
        }
        const auto telling = std::ranges::find_if(
            corners, [](const auto& corner) { return corner.arriving && corner.leaving; });
        const auto& corner = telling == corners.end() ? corners.front() : *telling;
        const auto one = knobsAt(corner, shape.tolerance);
        if (offerKnobs(shape, trial, ends, one.value_or(Knobs{}))) {
            return;
        }
    }
    for (const Ends ends : waysToEnd(shape)) {
        if (offerLocalKnobs(shape, trial, ends)) {
            return;
        }
    }
}

} // namespace splineloft::conversion
