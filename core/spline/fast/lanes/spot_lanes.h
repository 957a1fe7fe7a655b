// The inner loops of evaluation here and there, compiled for every set of instructions.
#pragma once

#include <cstddef>
#include <cstdint>

namespace splineloft::lanes {

/// Knots at `start` + i * `interval`, and what follows from them.
struct EvenKnots {
    double start = 0, end = 0, interval = 0;
    double over = 0; ///< 1 / interval
    double last = 0; ///< number of the last piece
};

/// For each t the piece it falls on and u, as KnotLine::locate does. Writes, and reads, up to
/// `spotPadding` more.
void locateEvenly(const EvenKnots& knots, const double* t, std::size_t count, std::int32_t* pieces,
                  double* u);
inline constexpr std::size_t spotPadding = 64;

/// Horner's scheme with other coefficients for each of `count` spots.
struct Spots {
    std::size_t count = 0;
    int degree = 0;
    std::size_t columns = 0;              ///< numbers of a row: 1, 2, or a multiple of 4
    const double* coefficients = nullptr; ///< of all pieces, degree + 1 rows each
    const std::int32_t* pieces = nullptr; ///< of each spot
    const double* x = nullptr;
    const double* scale = nullptr;   ///< factor of the value; none in power form
    const double* fromEnd = nullptr; ///< 1 where the rows are meant in reverse; where scaled
};

/// Writes count x columns numbers. One vector holds coordinates of one spot.
void evaluateSpots(const Spots& spots, double* out);

/// The same where all spots lie on the first piece: one vector holds one coordinate of many spots.
/// Writes `width` columns, `stride` apart. Reads and writes up to `spotPadding` more of each.
void evaluateSpotsOfOnePiece(const Spots& spots, std::size_t width, std::size_t stride,
                             double* out);

} // namespace splineloft::lanes
