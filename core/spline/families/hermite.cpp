// Hermite: points and the tangents at them, both given by hand.
#include "core/spline/families/hermite_form.h"
#include "core/spline/family.h"

namespace splineloft::families {
namespace {

struct Hermite {
    template <Blendable T>
    static void piece(const Input<T>& input, std::size_t i, std::span<T> bezier) {
        hermiteToBezier(input.points[i], input.tangents[i], input.tangents[i + 1],
                        input.points[i + 1], bezier);
    }
};

} // namespace

Family hermite() {
    return localFamily<Hermite>({
        .id = "hermite",
        .name = "Hermite",
        .summary = "Passes through every point with the tangent that you give it there.",
        .source = "Hermite 1878 · Ferguson 1964",
        .ends = {Ends::none},
        .usesTangents = true,
        .layout = twoPointCubic,
    });
}

} // namespace splineloft::families
