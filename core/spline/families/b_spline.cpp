// B-spline of any degree, with uniform knots, knots spaced by the legs of its polygon, or knots of
// one's own.
#include "core/spline/families/blossom.h"

namespace splineloft::families {

Family bSpline() {
    return localFamily<Blossom>({
        .id = "b-spline",
        .name = "B-spline",
        .summary = "Approaches its points as smoothly as its degree allows, and stays in their "
                   "hull unless its "
                   "ends are reflected.",
        .source = "Schoenberg 1946 · de Boor 1972 · Riesenfeld 1973",
        .parameters = bSplineParameters(),
        .ends = {Ends::doubled, Ends::open, Ends::reflected, Ends::clamped},
        .usesKnots = true,
        .spacing = Spacing::knotVector,
        .layout = [](const Extent& extent) { return Blossom::layout(extent, Form::polynomial); },
    });
}

} // namespace splineloft::families
