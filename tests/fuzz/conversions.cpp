// Any curve as every other family: the same curve, or a refusal in words.
#include "core/spline/catalog.h"
#include "core/spline/change/convert.h"
#include "tests/fuzz/curve_from_bytes.h"

#include <algorithm>
#include <cmath>
#include <limits>

using namespace splineloft;

namespace {

double sizeOf(const Pieces& pieces) {
    double size = 0;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        for (int k = 0; k <= pieces.degree(); ++k) {
            size = std::max(size, norm(pieces[i].bezierPoint(k)));
        }
    }
    return size;
}

void checkSame(const Pieces& before, const Pieces& after) {
    fuzz::require(before.size() == after.size(), "a conversion keeps the pieces");
    // The smallest of numbers lie one unit apart, and each step of a conversion may round by one.
    constexpr double units = 64 * std::numeric_limits<double>::denorm_min();
    const double allowed = std::max(1e-8 * sizeOf(before), units);
    for (std::size_t i = 0; i < before.size(); ++i) {
        for (const double u : {0.0, 0.3, 1.0}) {
            const double off = distance(before.position({i, u}), after.position({i, u}));
            fuzz::require(off <= allowed, "a conversion keeps the curve");
        }
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    fuzz::Bytes bytes(data, size);
    const Curve curve = fuzz::curveFrom(bytes);
    if (problemOf(curve)) {
        return 0;
    }
    const Pieces pieces = piecesOf(curve);
    for (const auto& family : catalog()) {
        const auto result = converted(curve, family.id);
        if (const auto* problem = std::get_if<Problem>(&result)) {
            fuzz::require(!problem->what.empty() && !problem->remedy.empty(),
                          "a refusal has words");
            continue;
        }
        const Curve& same = std::get<Curve>(result);
        fuzz::require(same.family == family.id, "a conversion has the family asked for");
        fuzz::require(!problemOf(same), "a conversion has no problem");
        checkSame(pieces, piecesOf(same));
    }
    return 0;
}
