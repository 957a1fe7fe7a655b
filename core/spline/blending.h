// How a spline's points become the input of its family: shared by the blending of coordinates and
// that of recipes.
#pragma once

#include "core/spline/arrangement.h"

#include <vector>

namespace splineloft {

/// The parameters of a spline as its family reads them: at the arranged places where local.
struct Settings {
    std::vector<double> parameters;
    std::vector<std::vector<double>> local;
    std::vector<double> weights; ///< of the places; none in families that use none
};

Settings settingsOf(const Spline& spline, const Arrangement& arrangement);

/// Bézier points of a piece.
inline std::size_t bezierPointsOf(const Layout& layout) {
    return static_cast<std::size_t>(layout.degree) + 1;
}

template <Blendable T>
Input<T> inputFor(bool closed, const Arrangement& arrangement, const Settings& settings,
                  std::span<const T> points, std::span<const T> tangents) {
    return {points,
            tangents,
            arrangement.knots,
            arrangement.intervals,
            settings.parameters,
            settings.local,
            arrangement.windows,
            arrangement.layout,
            closed};
}

} // namespace splineloft
