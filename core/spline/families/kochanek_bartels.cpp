// Kochanek-Bartels: the cardinal spline's tangent, shared out between the chord before a point and
// the chord after it by tension, continuity and bias, and allowed to differ on the two sides.
#include "core/spline/families/hermite_form.h"
#include "core/spline/family.h"

namespace splineloft::families {
namespace {

struct KochanekBartels {
    template <Blendable T>
    static void piece(const Input<T>& input, std::size_t i, std::span<T> bezier) {
        const double t = input.parameters[0];
        const double c = input.parameters[1];
        const double b = input.parameters[2];
        const auto p = input.points.subspan(i, 4);
        const T leaving = 0.5 * (1 - t) * (1 + c) * (1 + b) * (p[1] - p[0]) +
                          0.5 * (1 - t) * (1 - c) * (1 - b) * (p[2] - p[1]);
        const T arriving = 0.5 * (1 - t) * (1 - c) * (1 + b) * (p[2] - p[1]) +
                           0.5 * (1 - t) * (1 + c) * (1 - b) * (p[3] - p[2]);
        hermiteToBezier<T>(p[1], leaving, arriving, p[2], bezier);
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
            .meaning = meaning};
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
