// A table in which a value of x finds its piece of a function, however uneven the pieces are.
#pragma once

#include "core/spline/fast/buckets.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace splineloft {

/// As many buckets as pieces, equally wide: each names the last piece that begins before it. From
/// there halving steps lead on, as many as the fullest bucket needs.
class PieceTable {
  public:
    /// Begins anew: for pieces from x = start to x = end, fewer than 2^32.
    void begin(std::size_t pieces, double start, double end);
    /// Enters the points x[first] to x[last - 1], of those where pieces begin or end; in turn.
    void enter(const double* x, std::size_t first, std::size_t last);

    /// A piece that begins before x or there, not far before the one where x is. x is between the
    /// points.
    std::size_t pieceBefore(double x) const { return lastBefore_[buckets_.of(x)]; }
    /// From there steps of this size, a half of it and so on to 1 lead to the piece where x is:
    /// each is to be made if it does not lead beyond x. 0 or a power of 2.
    std::size_t firstStep() const { return firstStep_; }

  private:
    void enterSome(const double* x, std::size_t first, std::size_t last);

    std::size_t pieces_ = 0;
    Buckets buckets_;
    std::vector<std::uint32_t> lastBefore_;
    std::size_t firstStep_ = 0;
};

} // namespace splineloft
