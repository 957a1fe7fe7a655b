// The length of any curve: finite, never less than the way straight through, and found again.
#include "core/spline/measure/length.h"
#include "core/spline/measure/sample.h"
#include "core/spline/problem.h"
#include "tests/fuzz/curve_from_bytes.h"

#include <cmath>

using namespace splineloft;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    fuzz::Bytes bytes(data, size);
    const double part = bytes.part();
    const Curve curve = fuzz::curveFrom(bytes);
    if (problemOf(curve)) {
        return 0;
    }
    const Pieces pieces = piecesOf(curve);
    const ArcLength lengths(pieces);
    const double total = lengths.total();
    fuzz::require(std::isfinite(total) && total >= 0, "the length is a finite number");
    if (pieces.empty()) {
        return 0;
    }
    double straight = 0; // jumps between broken pieces do not count
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        straight += distance(pieces.position({i, 0}), pieces.position({i, 1}));
    }
    fuzz::require(total >= straight * (1 - 1e-9), "no curve is shorter than straight lines");
    const Spot spot = lengths.spotAt(part * total);
    fuzz::require(spot.segment < pieces.size() && spot.u >= 0 && spot.u <= 1, "a spot is on it");
    fuzz::require(std::abs(lengths.upTo(spot) - part * total) <= 1e-7 * total,
                  "the spot at a length lies at that length");
    for (const auto& sample : spread(pieces, lengths, Even::length, 9)) {
        fuzz::require(sample.segment < pieces.size(), "even spots are on the curve");
    }
    return 0;
}
