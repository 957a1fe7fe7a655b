// NURBS, non-uniform rational B-spline: a B-spline one dimension up, seen from the origin. A weight
// pulls the curve toward its control point, and the conic sections, the circle among them, are
// drawn exactly.
#include "core/spline/families/blossom.h"

namespace splineloft::families {

Family nurbs() {
    return localFamily<Blossom>({
        .id = "nurbs",
        .name = "NURBS",
        .summary = "A B-spline whose points have weights: a heavier point pulls harder, and "
                   "circles are exact.",
        .source = "Versprille 1975 · Piegl and Tiller 1997",
        .parameters = bSplineParameters(),
        .ends = {Ends::clamped, Ends::open, Ends::doubled, Ends::reflected},
        .usesKnots = true,
        .usesWeights = true,
        // Second derivatives multiply it by up to 10^40 where weights differ by 10^18.
        .mostCoordinate = 1e250,
        .spacing = Spacing::knotVector,
        .layout = [](const Extent& extent) { return Blossom::layout(extent, Form::rational); },
    });
}

} // namespace splineloft::families
