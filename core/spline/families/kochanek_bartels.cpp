// Kochanek-Bartels: the cardinal spline's tangent, shared out between the chord before a point and
// the chord after it by tension, continuity and bias, and allowed to differ on the two sides.
#include "core/spline/families/hermite_form.h"
#include "core/spline/family.h"

namespace splineloft::families {
namespace {

struct KochanekBartels {
    template <Blendable T>
    static void piece(const Input<T>& input, std::size_t i, std::span<T> bezier) {
        const auto p = input.points.subspan(i, 4);
        hermiteToBezier<T>(p[1], tangent(input, i + 1, 1), tangent(input, i + 2, -1), p[2], bezier);
    }

    /// The tangent at a point with which the curve leaves it (side 1) or arrives there (side -1).
    template <Blendable T> static T tangent(const Input<T>& input, std::size_t at, int side) {
        const double t = input.parameterAt(0, at);
        const double c = side * input.parameterAt(1, at);
        const double b = input.parameterAt(2, at);
        const auto p = input.points.subspan(at - 1, 3);
        return 0.5 * (1 - t) * (1 + c) * (1 + b) * (p[1] - p[0]) +
               0.5 * (1 - t) * (1 - c) * (1 - b) * (p[2] - p[1]);
    }
};

Parameter knob(std::string_view key, std::string_view label, std::string_view symbol,
               std::string_view meaning) {
    return {.key = key,
            .label = label,
            .symbol = symbol,
            .least = -1,
            .most = 1,
            .sliderLeast = -1,
            .sliderMost = 1,
            .neutral = 0,
            .scale = Scale::linear,
            .meaning = meaning,
            .local = true};
}

} // namespace

Family kochanekBartels() {
    return localFamily<KochanekBartels>({
        .id = "kochanek-bartels",
        .name = "Kochanek-Bartels",
        .summary =
            "Passes through every point; tension, continuity and bias shape how it turns there.",
        .source = "Kochanek and Bartels 1984",
        .parameters = {knob("tension", "Tension", "t",
                            "0 is Catmull-Rom; 1 turns tightly, −1 widely"),
                       knob("continuity", "Continuity", "c",
                            "0 is smooth; −1 gives the polygon's corner, 1 turns it inside out"),
                       knob("bias", "Bias", "b",
                            "0 is even; 1 overshoots the point, −1 turns before it")},
        .ends = {Ends::doubled, Ends::open, Ends::reflected},
        .layout = fourPointCubic,
    });
}

} // namespace splineloft::families
