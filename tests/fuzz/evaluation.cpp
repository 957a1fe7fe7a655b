// Pieces, blends, jets, ladder, joints and bounds of any curve: finite, and of one mind.
#include "core/spline/continuity.h"
#include "core/spline/measure/bounds.h"
#include "core/spline/problem.h"
#include "core/spline/traits.h"
#include "tests/fuzz/curve_from_bytes.h"

#include <cmath>
#include <limits>

using namespace splineloft;

namespace {

bool finite(const Point& point) {
    return std::isfinite(norm(point));
}

void checkSpot(const Pieces& pieces, Spot spot) {
    const Jet jet = pieces.jet(spot);
    fuzz::require(finite(jet.position), "the position is finite");
    fuzz::require(finite(jet.first) && finite(jet.second), "the derivatives by u are finite");
    fuzz::require(!jet.curvature || std::isfinite(*jet.curvature), "the curvature is finite");
    const auto ladder = pieces[spot.segment].ladder(spot.u);
    fuzz::require(finite(ladder.tip()), "the tip of the ladder is finite");
    fuzz::require(ladder.degree() == pieces.degree(), "the ladder has a level for each degree");
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    fuzz::Bytes bytes(data, size);
    const double part = bytes.part();
    const Curve curve = fuzz::curveFrom(bytes);
    if (const auto problem = problemOf(curve)) {
        fuzz::require(!problem->what.empty() && !problem->remedy.empty(), "a problem has words");
        return 0;
    }
    const Pieces pieces = piecesOf(curve);
    const BlendPieces blends = blendsOf(curve);
    fuzz::require(pieces.size() == blends.size(), "as many pieces of blends as of places");
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        for (const double u : {0.0, part, 1.0}) {
            checkSpot(pieces, {i, u});
            const Blend basis = blends.basis({i, u});
            for (const auto& share : basis.shares()) {
                fuzz::require(std::isfinite(share.weight), "basis functions are finite");
            }
        }
    }
    const auto box = bounds(pieces);
    fuzz::require(box.has_value() == !pieces.empty(), "a curve has bounds");
    if (box) {
        const Point inside = pieces.position({pieces.size() / 2, part});
        for (int c = 0; c < pieces.dimension(); ++c) {
            // Below the normal numbers rounding is no longer in proportion to what is rounded.
            const double slack = 1e-9 * (std::abs(box->low[c]) + std::abs(box->high[c])) +
                                 std::numeric_limits<double>::min();
            fuzz::require(inside[c] >= box->low[c] - slack && inside[c] <= box->high[c] + slack,
                          "the curve is within its bounds");
        }
    }
    for (const auto& joint : jointsOf(pieces, curve.closed)) {
        fuzz::require(!describe(joint).empty(), "a joint has words");
    }
    traitsOf(curve, pieces, blends);
    return 0;
}
