// The nearest spot of any curve to any place: none of a few others is nearer.
#include "core/spline/measure/nearest.h"
#include "core/spline/problem.h"
#include "tests/fuzz/curve_from_bytes.h"

#include <algorithm>
#include <cmath>

using namespace splineloft;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    fuzz::Bytes bytes(data, size);
    const Curve curve = fuzz::curveFrom(bytes);
    if (problemOf(curve)) {
        return 0;
    }
    Point place(curve.points.dimension());
    for (int c = 0; c < place.dimension(); ++c) {
        const double x = bytes.number();
        place[c] = std::abs(x) <= 1e300 ? x : 0;
    }
    const Pieces pieces = piecesOf(curve);
    const auto nearest = nearestTo(pieces, place);
    fuzz::require(nearest.has_value() == !pieces.empty(), "a curve has a nearest spot");
    // Exact up to the rounding of positions: of a curve that reaches out to 1e300, be it in another
    // piece, no place can be promised to better than 1e284.
    double reach = norm(place);
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        for (int k = 0; k <= pieces.degree(); ++k) {
            reach = std::max(reach, norm(pieces[i].bezierPoint(k)));
        }
    }
    for (std::size_t i = 0; nearest && i < pieces.size(); ++i) {
        for (int k = 0; k <= 16; ++k) {
            const double other = distance(pieces.position({i, k / 16.0}), place);
            fuzz::require(nearest->distance <= other + 1e-12 * reach, "no other spot is nearer");
        }
    }
    return 0;
}
