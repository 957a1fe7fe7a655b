// Bézier: one piece, whose Bézier points are the control points themselves. Its degree is one less
// than their number, so every point pulls at the whole curve.
#include "core/spline/family.h"

#include <algorithm>

namespace splineloft::families {
namespace {

/// The ladder of degree n - 1 takes n^2 / 2 steps for every point drawn.
constexpr std::size_t mostLadderPoints = 256;

struct Bezier {
    template <Blendable T>
    static void piece(const Input<T>& input, std::size_t, std::span<T> bezier) {
        std::ranges::copy(input.points, bezier.begin());
    }
};

} // namespace

Family bezier() {
    return localFamily<Bezier>({
        .id = "bezier",
        .name = "Bézier",
        .summary =
            "One piece of degree n − 1, drawn toward every point, through the first and last.",
        .source = "de Casteljau 1959 · Bézier 1962",
        .ends = {Ends::none},
        .closable = false,
        .mostPoints = mostLadderPoints,
        .layout = onePiece,
    });
}

} // namespace splineloft::families
