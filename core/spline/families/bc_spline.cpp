// BC-spline: the symmetric, once differentiable cubic filters on four points that reproduce
// constants, as a square in b and c. Its edges are the families of the 1983 memo: (b, 0) is Duff's
// with tension b, (0, c) the cardinal spline of tension c.
#include "core/spline/family.h"

namespace splineloft::families {
namespace {

struct BcSpline {
    template <Blendable T>
    static void piece(const Input<T>& input, std::size_t i, std::span<T> bezier) {
        const double b = input.parameters[0];
        const double c = input.parameters[1];
        const auto p = input.points.subspan(i, 4);
        // Where the piece starts: a share b/6 of each neighbour; the tangent there is that of a
        // cardinal spline of tension b/2 + c.
        const auto joint = [b](const T& before, const T& at, const T& after) {
            return (1 - b / 3) * at + (b / 6) * (before + after);
        };
        const double third = (b / 2 + c) / 3;
        bezier[0] = joint(p[0], p[1], p[2]);
        bezier[3] = joint(p[1], p[2], p[3]);
        bezier[1] = bezier[0] + third * (p[2] - p[0]);
        bezier[2] = bezier[3] - third * (p[3] - p[1]);
    }
};

} // namespace

Family bcSpline() {
    return localFamily<BcSpline>({
        .id = "bc-spline",
        .name = "BC-spline",
        .summary = "The smooth symmetric cubics on four points: B-spline (1, 0), Catmull-Rom (0, "
                   "½), Duff's "
                   "(b, 0), cardinal (0, c).",
        .source = "Mitchell and Netravali 1988",
        .parameters = {{.key = "b",
                        .label = "B",
                        .symbol = "b",
                        .least = 0,
                        .most = 1,
                        .sliderLeast = 0,
                        .sliderMost = 1,
                        .neutral = 1.0 / 3,
                        .scale = Scale::linear,
                        .meaning = "0 passes through the points; with c = 0 it is Duff's tension"},
                       {.key = "c",
                        .label = "C",
                        .symbol = "c",
                        .least = -100,
                        .most = 100,
                        .sliderLeast = 0,
                        .sliderMost = 1,
                        .neutral = 1.0 / 3,
                        .scale = Scale::linear,
                        .meaning = "with b = 0 it is the cardinal tension; (⅓, ⅓) is Mitchell's"}},
        .ends = {Ends::doubled, Ends::open, Ends::reflected},
        .layout = fourPointCubic,
    });
}

} // namespace splineloft::families
