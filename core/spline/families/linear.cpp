// Linear: from point to point in straight lines. What all the other families improve on.
#include "core/spline/family.h"

namespace splineloft::families {
namespace {

struct Linear {
    template <Blendable T>
    static void piece(const Input<T>& input, std::size_t i, std::span<T> bezier) {
        bezier[0] = input.points[i];
        bezier[1] = input.points[i + 1];
    }
};

} // namespace

Family linear() {
    return localFamily<Linear>({
        .id = "linear",
        .name = "Linear",
        .summary = "Straight lines from point to point: the control polygon itself.",
        .source = "Euclid, Elements I",
        .ends = {Ends::none},
        .layout = [](const Extent&) { return Layout{1, 2, 1, 0}; },
    });
}

} // namespace splineloft::families
