// Barsky's beta-spline: at each joint the speed jumps by the ratio bias, and direction and
// curvature are continuous whatever bias and tension are.
#include "core/spline/family.h"

namespace splineloft::families {
namespace {

struct Beta {
    template <Blendable T>
    static void piece(const Input<T>& input, std::size_t i, std::span<T> bezier) {
        const double b1 = input.parameters[0];
        const double b2 = input.parameters[1];
        const double square = b1 * b1;
        const double cube = b1 * square;
        const double scale = 1 / (b2 + 2 * cube + 4 * square + 4 * b1 + 2);
        const auto p = input.points.subspan(i, 4);
        // The middle weight of a joint, and the weights of the inner Bézier points on their leg.
        const double middle = b2 + 4 * square + 4 * b1;
        const double nearStart = 2 * (1 + b1);
        const double nearEnd = 2 * square * (1 + b1);
        bezier[0] = scale * (2 * cube * p[0] + middle * p[1] + 2.0 * p[2]);
        bezier[1] = lerp(p[1], p[2], scale * nearStart);
        bezier[2] = lerp(p[2], p[1], scale * nearEnd);
        bezier[3] = scale * (2 * cube * p[1] + middle * p[2] + 2.0 * p[3]);
    }
};

} // namespace

Family beta() {
    return localFamily<Beta>({
        .id = "beta",
        .name = "Beta-spline",
        .summary =
            "A B-spline with bias and tension: direction and curvature stay continuous, speed "
            "may jump.",
        .source = "Barsky 1981",
        .parameters = {{.key = "bias",
                        .label = "Bias",
                        .symbol = "β₁",
                        .least = 1e-3,
                        .most = 1e3,
                        .sliderLeast = 1.0 / 16,
                        .sliderMost = 16,
                        .neutral = 1,
                        .scale = Scale::ratio,
                        .meaning =
                            "speed after a joint ÷ speed before it; 1 is neutral, 1/β₁ mirrors"},
                       {.key = "tension",
                        .label = "Tension",
                        .symbol = "β₂",
                        .least = 0,
                        .most = 1e6,
                        .sliderLeast = 0,
                        .sliderMost = 50,
                        .neutral = 0,
                        .scale = Scale::linear,
                        .meaning = "0 is neutral; larger clings to the polygon"}},
        .ends = {Ends::doubled, Ends::open, Ends::reflected},
        .layout = fourPointCubic,
    });
}

} // namespace splineloft::families
