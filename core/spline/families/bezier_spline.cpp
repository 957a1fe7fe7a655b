// Bézier spline: cubic Bézier pieces end to end, as pen tools draw them. The control points are
// anchor, handle, handle, anchor, ...; points beyond the last whole piece wait for their partners.
#include "core/spline/family.h"

#include <algorithm>

namespace splineloft::families {
namespace {

struct BezierSpline {
    template <Blendable T>
    static void piece(const Input<T>& input, std::size_t first, std::span<T> bezier) {
        std::ranges::copy(input.points.subspan(first, 4), bezier.begin());
    }
};

} // namespace

Family bezierSpline() {
    return localFamily<BezierSpline>({
        .id = "bezier-spline",
        .name = "Bézier spline",
        .summary = "Cubic pieces end to end: anchor, handle, handle, anchor, as a pen tool draws.",
        .source = "Bézier 1962",
        .ends = {Ends::none},
        .hasHandles = true,
        .layout = [](const Extent&) { return Layout{3, 4, 3, 0}; },
    });
}

} // namespace splineloft::families
