// Duff's tensioned B-spline: the inner Bézier points lie on the leg of the polygon, a/3 from either
// end of it, and each joint is halfway between the Bézier points around it.
#include "core/spline/family.h"

namespace splineloft::families {
namespace {

struct Duff {
    template <Blendable T>
    static void piece(const Input<T>& input, std::size_t i, std::span<T> bezier) {
        const double third = input.parameters[0] / 3;
        const auto p = input.points.subspan(i, 4);
        bezier[0] = 0.5 * (lerp(p[1], p[0], third) + lerp(p[1], p[2], third));
        bezier[1] = lerp(p[1], p[2], third);
        bezier[2] = lerp(p[2], p[1], third);
        bezier[3] = 0.5 * (lerp(p[2], p[1], third) + lerp(p[2], p[3], third));
    }
};

} // namespace

Family duff() {
    return localFamily<Duff>({
        .id = "duff",
        .name = "Duff's tensioned B-spline",
        .summary = "A B-spline with tension: slackened toward the B-spline, tightened toward the "
                   "polygon.",
        .source = "Duff, in Smith 1983",
        .parameters = {{.key = "tension",
                        .label = "Tension",
                        .symbol = "a",
                        .least = 0,
                        .most = 1,
                        .sliderLeast = 0,
                        .sliderMost = 1,
                        .neutral = 1,
                        .scale = Scale::linear,
                        .meaning = "1 is the B-spline; toward 0 it clings to the polygon"}},
        .ends = {Ends::doubled, Ends::open, Ends::reflected},
        .layout = fourPointCubic,
    });
}

} // namespace splineloft::families
