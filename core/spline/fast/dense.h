// Many points of every piece at once, as drawing and export want them: equal steps of u.
//
// The pieces become polynomials in Horner's form (see lanes/horner.h), and the samples lie side by
// side in the lanes of whatever vectors the machine has: one program serves them all. Output beyond
// the last-level cache is written past the caches.
#pragma once

#include "core/spline/piece.h"

#include <cstddef>
#include <span>
#include <vector>

namespace splineloft {

/// Number of points at `perPiece` equal steps of u on each piece and at the very end: pieces x
/// perPiece + 1. None where there are no pieces, or no steps.
std::size_t placesPerPiece(const Pieces& pieces, std::size_t perPiece);

/// The positions there, `dimension` numbers each, row after row: those of `spreadPerPiece`. Works
/// for every degree, dimension and form. u = 0 gives the Bézier point itself, and so does the end.
///
/// In units of the largest Bézier coordinate of the piece (on a rational piece, times the ratio of
/// its weights), doubles are within 1e-13 of the exact value up to degree 400, cubics within 1e-14.
/// Throws std::invalid_argument if `out` is of another size than placesPerPiece x dimension.
void positionsPerPiece(const Pieces& pieces, std::size_t perPiece, std::span<double> out);
/// The same in single precision. Polynomial pieces up to degree 5 are computed in it, within 5e-7;
/// others are rounded once. u = 0 and the end are exact here, too, as far as floats are.
void positionsPerPiece(const Pieces& pieces, std::size_t perPiece, std::span<float> out);

/// What a table of jets holds, one row a place.
struct DenseJets {
    std::vector<double> positions; ///< `dimension` numbers a place
    std::vector<double> firsts;    ///< derivatives by u, as many
    /// One number a place, 1 / unit of length: signed in the plane (left turns are positive), not
    /// negative elsewhere. 0 where the speed is zero or the curvature too large for a number,
    /// where Jet has none: never infinite, never NaN.
    std::vector<double> curvatures;
};

/// Positions, derivatives and curvatures at the same places. Near cusps curvature is as uncertain
/// as rounding makes the speed.
DenseJets jetsPerPiece(const Pieces& pieces, std::size_t perPiece);
/// The same into tables made before, which are resized only if need be.
void jetsPerPiece(const Pieces& pieces, std::size_t perPiece, DenseJets& jets);

} // namespace splineloft
