// Parametric parabola: through three points, the middle one at parameter mu. Every mu gives another
// parabola (lecture, figure 2). With more points, parabola follows parabola: the third point of one
// is the first of the next.
#include "core/spline/family.h"

namespace splineloft::families {
namespace {

struct ParametricParabola {
    template <Blendable T>
    static void piece(const Input<T>& input, std::size_t first, std::span<T> bezier) {
        const double mu = input.parameters[0];
        const auto p = input.points.subspan(first, 3);
        bezier[0] = p[0];
        bezier[2] = p[2];
        // What P1 = (1 - mu)^2 P0 + 2 mu (1 - mu) B1 + mu^2 P2 asks of the middle Bézier point.
        bezier[1] =
            (1 / (2 * mu * (1 - mu))) * (p[1] - (1 - mu) * (1 - mu) * p[0] - mu * mu * p[2]);
    }
};

} // namespace

Family parametricParabola() {
    return localFamily<ParametricParabola>({
        .id = "parametric-parabola",
        .name = "Parametric parabola",
        .summary =
            "Through three points; μ says when it reaches the middle one, and so which of many "
            "parabolas it is.",
        .source = "Lecture 11, Introduction to Spline Curves",
        .parameters =
            {{.key = "mu",
              .label = "Middle point at",
              .symbol = "μ",
              .least = 1e-3,
              .most = 1 - 1e-3,
              .sliderLeast = 0.02,
              .sliderMost = 0.98,
              .neutral = 0.5,
              .scale = Scale::linear,
              .meaning =
                  "½ shares the time evenly; (x₁ − x₀) / (x₂ − x₀) makes three points y = f(x)"}},
        .ends = {Ends::none},
        .layout = [](const Extent&) { return Layout{2, 3, 2, 0}; },
    });
}

} // namespace splineloft::families
