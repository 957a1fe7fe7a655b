// The blossom of a B-spline: its polynomial with an argument for each degree (Ramshaw 1987). On a
// piece over [a, b] the Bézier point number j is the blossom of degree - j times a and j times b.
#pragma once

#include "core/spline/family.h"

#include <algorithm>
#include <vector>

namespace splineloft::families {

struct Blossom {
    /// de Boor's triangle over the knots around a piece, with `fromEnd` of the arguments at the end
    /// of the piece and the others at its start.
    template <Blendable T>
    static T at(const Input<T>& input, std::size_t window, int fromEnd, std::vector<T>& rungs) {
        const auto degree = static_cast<std::size_t>(input.layout.degree);
        const auto knots = input.knots.subspan(window, 2 * degree + 2);
        std::ranges::copy(input.points.subspan(window, degree + 1), rungs.begin());
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
    static void piece(const Input<T>& input, std::size_t window, std::span<T> bezier) {
        std::vector<T> rungs(bezier.size());
        for (std::size_t j = 0; j < bezier.size(); ++j) {
            bezier[j] = at(input, window, static_cast<int>(j), rungs);
        }
    }

    /// Degree and window of the family's first parameter, the degree.
    static Layout layout(const Extent& extent, Form form) {
        const int d = static_cast<int>(extent.parameters[0]);
        return {d, d + 1, 1, (d - 1) / 2, form};
    }
};

/// The parameters of a B-spline: its degree, and how its knots are spaced.
inline std::vector<Parameter> bSplineParameters() {
    return {{.key = "degree",
             .label = "Degree",
             .symbol = "d",
             .least = 1,
             .most = 25,
             .sliderLeast = 1,
             .sliderMost = 7,
             .neutral = 3,
             .scale = Scale::whole,
             .meaning = "3 is cubic; 1 is the polygon, higher is smoother and looser"},
            {.key = "alpha",
             .label = "Knot spacing",
             .symbol = "α",
             .least = 0,
             .most = 1,
             .sliderLeast = 0,
             .sliderMost = 1,
             .neutral = 0,
             .scale = Scale::linear,
             .meaning = "0 is uniform; 1 spaces the knots by the legs of the polygon"}};
}

} // namespace splineloft::families
