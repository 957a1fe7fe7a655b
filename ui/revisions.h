// What changed when, block by block: for copies that are kept elsewhere (on the graphics card) and
// brought up to date.
#pragma once

#include "core/spline/ranges.h"

#include <cstdint>
#include <vector>

namespace splineloft::ui {

/// The history of one sequence, told in blocks of its members.
class Revisions {
  public:
    /// Of a sequence of so many blocks, all of them new.
    explicit Revisions(std::size_t blocks = 0);

    /// These blocks have changed.
    void note(const Range& blocks);

    /// No other sequence ever has the same number.
    std::uint64_t identity() const { return identity_; }
    /// Grows with every change.
    std::uint64_t revision() const { return revision_; }
    std::size_t blocks() const { return stamps_.size(); }
    /// The blocks that have changed since a revision, in order.
    std::vector<Range> since(std::uint64_t revision) const;

  private:
    std::uint64_t identity_;
    std::uint64_t revision_ = 1;
    std::vector<std::uint64_t> stamps_; // of each block, the revision of its last change
};

} // namespace splineloft::ui
