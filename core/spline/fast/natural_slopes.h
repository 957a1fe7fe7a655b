// The slopes of the natural cubic spline of a function.
#pragma once

#include "core/spline/fast/lanes/slope_lanes.h"

#include <cstddef>
#include <memory>
#include <span>

namespace splineloft {

/// The slopes that a natural cubic spline through the points (x[i], y[i]) has there, worked out
/// block by block, so that all in between stays in the cache. Whoever has to bring the points may
/// do so block by block as well, just before they are used. They are at least 2; x rises, over
/// 2^-150 to 2^250 in all, and its intervals differ up to 10^100-fold; y are below 2^250. O(n).
class NaturalSlopes {
  public:
    /// All three equally long.
    NaturalSlopes(std::span<const double> x, std::span<const double> y, std::span<double> slopes);

    /// At least 1.
    std::size_t blocks() const;
    /// So many points, from the first on, must be there before a block is solved.
    std::size_t pointsFor(std::size_t block) const;
    /// One block after another. After the last one all slopes are there. While this one is worked
    /// out, memory may bring what the next one will be brought from.
    void solve(std::size_t block, const lanes::Upcoming& upcoming = {});

  private:
    /// What one instruction stores at most, and best does so within a line of the cache.
    struct alignas(64) Line {
        double numbers[8];
    };

    void cut(std::size_t blocks);
    std::size_t firstOf(std::size_t block) const { return 1 + block * length_ * chains_; }
    lanes::SlopeBlock columnsOf(std::size_t block) const;
    double firstChord() const;
    void substitute(std::size_t block, double next);
    void solveRest();

    std::span<const double> x_, y_;
    std::span<double> slopes_;
    std::size_t chains_;
    std::size_t blocks_ = 0;                  ///< in chains: none where rows are few
    std::size_t length_ = 0, lastLength_ = 0; ///< of chains in all blocks, in the last one
    std::size_t room_ = 0;                    ///< lines, for what a block has of a kind
    std::unique_ptr<Line[]> columns_; ///< slopes, and what is left of the rows of two blocks
    lanes::SlopeState state_{};       ///< after the rows so far
    double foreseen_ = 0;             ///< the slope behind the block substituted last
    bool wasForeseen_ = true;         ///< rightly, behind every block
};

} // namespace splineloft
