// B-spline of any degree. Its Bézier points are blossoms: the point number j of a piece over
// [a, b] is the blossom of degree - j times a and j times b (Ramshaw 1987).
#include "core/spline/family.h"

#include <algorithm>
#include <vector>

namespace splineloft::families {
namespace {

struct BSpline {
    /// de Boor's triangle over the knots around piece i, with `fromEnd` of the arguments at the end
    /// of the piece and the others at its start.
    template <Blendable T>
    static T blossom(const Input<T>& input, std::size_t i, int fromEnd, std::vector<T>& rungs) {
        const auto degree = static_cast<std::size_t>(input.layout.degree);
        const auto knots = input.knots.subspan(i, 2 * degree + 2);
        std::ranges::copy(input.points.subspan(i, degree + 1), rungs.begin());
        for (std::size_t level = 0; level < degree; ++level) {
            const bool atEnd = level < static_cast<std::size_t>(fromEnd);
            const double argument = knots[atEnd ? degree + 1 : degree];
            for (std::size_t k = 0; k + level < degree; ++k) {
                const double a = knots[k + level + 1];
                const double b = knots[k + degree + 1];
                rungs[k] = lerp(rungs[k], rungs[k + 1], (argument - a) / (b - a));
            }
        }
        return rungs[0];
    }

    template <Blendable T>
    static void piece(const Input<T>& input, std::size_t i, std::span<T> bezier) {
        std::vector<T> rungs(bezier.size());
        for (std::size_t j = 0; j < bezier.size(); ++j) {
            bezier[j] = blossom(input, i, static_cast<int>(j), rungs);
        }
    }
};

} // namespace

Family bSpline() {
    return localFamily<BSpline>({
        .id = "b-spline",
        .name = "B-spline",
        .summary = "Approaches its points as smoothly as its degree allows, and stays in their "
                   "hull unless its "
                   "ends are reflected.",
        .source = "Schoenberg 1946 · de Boor 1972 · Riesenfeld 1973",
        .parameters = {{.key = "degree",
                        .label = "Degree",
                        .symbol = "d",
                        .least = 1,
                        .most = 25,
                        .sliderLeast = 1,
                        .sliderMost = 7,
                        .neutral = 3,
                        .scale = Scale::whole,
                        .meaning = "3 is cubic; 1 is the polygon, higher is smoother and looser"}},
        .ends = {Ends::doubled, Ends::open, Ends::reflected, Ends::clamped},
        .spacing = Spacing::knotVector,
        .layout =
            [](std::span<const double> parameters, std::size_t) {
                const int d = static_cast<int>(parameters[0]);
                return Layout{d, d + 1, 1, (d - 1) / 2};
            },
    });
}

} // namespace splineloft::families
