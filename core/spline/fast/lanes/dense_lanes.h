// The inner loops of dense evaluation, compiled for every set of instructions. Plain pointers and
// counts, so that nothing of the library's inline code is compiled for a machine that may not be
// there.
#pragma once

#include <cstddef>

namespace splineloft::lanes {

/// One run of samples on several pieces, computed in numbers of type Lane, written as Number.
template <class Lane, class Number> struct Task {
    const Lane* coefficients = nullptr; ///< constants of the first piece, a column each
    std::size_t rowStride = 0;          ///< from there to what belongs to x, and so on
    std::size_t pieceStride = 0;        ///< from piece to piece
    std::size_t pieces = 1;
    int degree = 0;
    const Lane* x = nullptr;     ///< `count` values, and `runPadding` more
    const Lane* scale = nullptr; ///< as many factors of the value; none in power form
    std::size_t count = 0;       ///< samples
    /// First points of the pieces, `pieceStride` apart, written as they are; none where Horner's
    /// scheme gives them exactly.
    const Number* starts = nullptr;
    Number* out = nullptr;     ///< where the first sample of the first piece goes
    std::size_t outStride = 0; ///< from piece to piece
};

/// Points of 1, 2 or 3 coordinates, row after row.
void samplePoints(const Task<double, double>& task, int dimension);
void samplePoints(const Task<double, float>& task, int dimension);
void samplePoints(const Task<float, float>& task, int dimension);

/// Copies past the caches.
void streamCopy(const double* from, std::size_t count, double* to);
void streamCopy(const float* from, std::size_t count, float* to);

} // namespace splineloft::lanes
