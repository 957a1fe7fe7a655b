// Which arcs of a curve may meet: those whose boxes overlap.
#pragma once

#include "core/spline/shape/arcs.h"

#include <cstdint>
#include <optional>
#include <span>

namespace splineloft {

/// Two of a curve's arcs, by their numbers.
struct ArcPair {
    std::size_t first = 0, second = 0; ///< first < second
};

/// All pairs of arcs whose boxes overlap within rounding, one after another. Boxes around
/// neighbours along the curve form a tree, and nothing is looked at inside of boxes that lie apart:
/// usually O(n log n), however long the row or tall the pile of arcs.
class ArcPairs {
  public:
    explicit ArcPairs(std::span<const Arc> arcs);

    /// The next pair. None after the last, or when more boxes have been compared than there is
    /// `work` left, from which they are taken.
    std::optional<ArcPair> next(std::int64_t& work);

  private:
    struct Box {
        std::array<double, 2> least, greatest;
    };
    static bool overlap(const Box& a, const Box& b);

    std::size_t leaves_ = 1; ///< of the tree, the boxes from this number on; 2 k and 2 k + 1 in k
    std::vector<Box> boxes_;
    std::vector<ArcPair> toCompare_; ///< boxes
};

} // namespace splineloft
