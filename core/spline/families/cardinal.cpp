// Cardinal: the tangent at each point is parallel to the chord between its neighbours, and a times
// as long (Smith 1983, where one printed constraint has a misprint: the chord is x1 - x[-1]).
#include "core/spline/families/hermite_form.h"
#include "core/spline/family.h"

namespace splineloft::families {
namespace {

struct Cardinal {
    template <Blendable T>
    static void piece(const Input<T>& input, std::size_t i, std::span<T> bezier) {
        const auto p = input.points.subspan(i, 4);
        hermiteToBezier<T>(p[1], input.parameterAt(0, i + 1) * (p[2] - p[0]),
                           input.parameterAt(0, i + 2) * (p[3] - p[1]), p[2], bezier);
    }
};

} // namespace

Family cardinal() {
    return localFamily<Cardinal>({
        .id = "cardinal",
        .name = "Cardinal",
        .summary =
            "Passes through every point; each tangent is a times the chord between the neighbours.",
        .source = "Catmull and Rom 1974 · Clark 1981",
        .parameters = {{.key = "tension",
                        .label = "Tension",
                        .symbol = "a",
                        .least = -100,
                        .most = 100,
                        .sliderLeast = 0,
                        .sliderMost = 2,
                        .neutral = 0.5,
                        .scale = Scale::linear,
                        .meaning = "½ is Catmull-Rom, 0 is straight; larger bends more sharply",
                        .local = true}},
        .ends = {Ends::doubled, Ends::open, Ends::reflected},
        .layout = fourPointCubic,
    });
}

} // namespace splineloft::families
