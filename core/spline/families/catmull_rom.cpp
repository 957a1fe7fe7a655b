// Catmull-Rom with uneven knots: the interval between two points is their distance to the power
// alpha. The tangents make each piece the blend of Barry and Goldman's pyramid.
#include "core/spline/families/hermite_form.h"
#include "core/spline/family.h"

namespace splineloft::families {
namespace {

/// The slope from a to b over an interval. Where the interval has shrunk to nothing the points
/// coincide, and in the limit the curve comes to rest there.
template <Blendable T> T slope(const T& a, const T& b, double interval) {
    return interval > 0 ? (1 / interval) * (b - a) : T{};
}

/// Derivative at b of the parabola through a, b and c.
template <Blendable T>
T parabolaTangent(const T& a, const T& b, const T& c, double before, double after) {
    return slope(a, b, before) - slope(a, c, before + after) + slope(b, c, after);
}

struct CatmullRom {
    template <Blendable T>
    static void piece(const Input<T>& input, std::size_t i, std::span<T> bezier) {
        const auto p = input.points.subspan(i, 4);
        const double before = input.intervals[i];
        const double own = input.intervals[i + 1];
        const double after = input.intervals[i + 2];
        hermiteToBezier<T>(p[1], own * parabolaTangent<T>(p[0], p[1], p[2], before, own),
                           own * parabolaTangent<T>(p[1], p[2], p[3], own, after), p[2], bezier);
    }
};

} // namespace

Family catmullRom() {
    return localFamily<CatmullRom>({
        .id = "catmull-rom",
        .name = "Catmull-Rom",
        .summary = "Passes through every point; α gives close points short intervals, and at ½ no "
                   "piece has a "
                   "cusp or a loop.",
        .source = "Catmull and Rom 1974 · Yuksel, Schaefer and Keyser 2011",
        .parameters = {{.key = "alpha",
                        .label = "Alpha",
                        .symbol = "α",
                        .least = 0,
                        .most = 1,
                        .sliderLeast = 0,
                        .sliderMost = 1,
                        .neutral = 0.5,
                        .scale = Scale::linear,
                        .meaning = "0 is uniform, ½ centripetal, 1 chordal"}},
        .ends = {Ends::doubled, Ends::open, Ends::reflected},
        .spacing = Spacing::chord,
        .layout = fourPointCubic,
    });
}

} // namespace splineloft::families
