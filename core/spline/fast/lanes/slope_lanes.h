// The equations of the slopes of a natural spline, eliminated and solved in many chains of rows
// side by side, compiled for every set of instructions.
#pragma once

#include <cstddef>

namespace splineloft::lanes {

/// So many chains are gone through at once.
std::size_t slopeChains();
inline constexpr std::size_t mostSlopeChains = 16;

/// A chain is at least so long.
inline constexpr std::size_t leastChain = 40;

/// What elimination hands on from row i, which has become m[i] + over m[i+1] = reduced.
struct SlopeState {
    double chord; ///< 3 times the slope of the piece behind point i
    double over, reduced;
    bool operator==(const SlopeState&) const = default;
};

/// The rows of points first .. first + chains * length - 1: chain after chain of `length` rows.
/// What becomes of them is kept in columns, one a chain: row r of chain c at [r * chains + c], with
/// room for one number more.
struct SlopeBlock {
    std::size_t first, length;
    double *over, *reduced;
};

/// What will be read next: memory may begin to bring it, as many numbers of both as there are rows
/// in a block.
struct Upcoming {
    const double *x = nullptr, *y = nullptr; ///< or nothing
};

/// Eliminates the rows of a block, from the state before its first row.
SlopeState eliminate(const double* x, const double* y, const SlopeBlock& block,
                     const SlopeState& before, const Upcoming& upcoming);

/// Eliminates rows first .. first + count - 1, one after another.
SlopeState eliminateOneByOne(const double* x, const double* y, std::size_t first, std::size_t count,
                             const SlopeState& before, double* over, double* reduced);

/// What the slope at the first point of a block will be, as a rule to the last bit, whatever
/// follows the block.
double foreseenSlope(const SlopeBlock& block);

/// The slopes at the points of a block, from the one behind it.
void substitute(const SlopeBlock& block, double next, double* slopes);

} // namespace splineloft::lanes
