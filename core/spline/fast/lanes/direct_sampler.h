// Dense points of polynomial pieces in 1 to 3 dimensions, written as they are computed.
#pragma once

#include "core/spline/piece.h"

#include <cstddef>
#include <span>

namespace splineloft::lanes {

/// Coordinates from which on points go by columns instead.
inline constexpr int mostDirectDimension = 3;

/// How results go to memory.
enum class Store {
    cached,  ///< as usual
    streamed ///< past the caches: quicker where they could not hold it all
};

/// The better way for so many bytes.
Store storeFor(std::size_t bytes);

/// Samples u = k / perPiece (k < perPiece) of every piece, row after row. `out` has room for just
/// these; the degree is at most `mostScaledDegree`.
void sampleDirectly(const Pieces& pieces, std::size_t perPiece, Store store, std::span<double> out);
void sampleDirectly(const Pieces& pieces, std::size_t perPiece, Store store, std::span<float> out);

} // namespace splineloft::lanes
