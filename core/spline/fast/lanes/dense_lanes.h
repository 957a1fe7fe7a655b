// The inner loops of dense evaluation, compiled for every set of instructions. Plain pointers and
// counts, so that nothing of the library's inline code is compiled for a machine that may not be
// there. All is computed in double, and rounded once where floats are wanted.
#pragma once

#include <cstddef>

namespace splineloft::lanes {

/// One run of samples on several pieces.
template <class Number> struct Task {
    const double* coefficients = nullptr; ///< constants of the first piece, a column each
    std::size_t rowStride = 0;            ///< from there to what belongs to x, and so on
    std::size_t pieceStride = 0;          ///< from piece to piece
    std::size_t pieces = 1;
    int degree = 0;
    const double* x = nullptr;     ///< `count` values, and `runPadding` more
    const double* scale = nullptr; ///< as many; none in power form
    std::size_t count = 0;         ///< samples
    Number* out = nullptr;         ///< where the first sample of the first piece goes
    std::size_t outStride = 0;     ///< from piece to piece
    Number* end = nullptr;         ///< nothing from here on may be written; before it anything may
};

/// Brings a table of `count` numbers (padded) into the order in which the lanes of `samplePoints`
/// in the plane hold samples, so that coordinates of type Number interleave without crossing lanes.
template <class Number> void arrangeForPairs(double* table, std::size_t count);

/// Points of 1, 2 or 3 coordinates, row after row. Writes some numbers beyond each run (though not
/// beyond `end`): go from the first run to the last.
void samplePoints(const Task<double>& task, int dimension);
void samplePoints(const Task<float>& task, int dimension);

/// Copies past the caches.
void streamCopy(const double* from, std::size_t count, double* to);
void streamCopy(const float* from, std::size_t count, float* to);

} // namespace splineloft::lanes
