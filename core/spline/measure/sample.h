// Points along a curve, for beads, travellers and export.
#pragma once

#include "core/spline/measure/length.h"
#include "core/spline/piece.h"

#include <cstddef>
#include <span>
#include <vector>

namespace splineloft {

/// What the samples are even in.
enum class Even {
    parameter, ///< equal steps of t
    length     ///< equal steps along the curve: constant speed
};

/// One sample.
struct Sample {
    Spot spot;
    double t = 0;      ///< parameter
    double length = 0; ///< from the start, along the curve
    Point position;
    Point tangent;                   ///< derivative of the position by t
    std::optional<double> curvature; ///< as in Jet
};

/// `count` spots (at least 2) from the start of the curve to its end.
std::vector<Spot> spread(const Pieces& pieces, const ArcLength& lengths, Even even,
                         std::size_t count);

/// Most spots that a spacing by distance may ask for.
inline constexpr std::size_t mostSpots = 2'000'000;

/// What becomes of the rest of a curve that is shorter than the distance of its spots.
enum class Remainder {
    bare,  ///< no spot after the last whole step: a closed curve has none twice, dashes keep time
    capped ///< the end of the curve is one more spot
};

/// Spots at the lengths 0, `distance`, twice `distance` and so on, in units of length. The end of
/// the curve is among them where it is a whole number of steps away, up to rounding.
/// Throws std::invalid_argument unless `distance` is above zero, and where it is so small that
/// there would be more than `mostSpots`.
std::vector<Spot> spreadByDistance(const Pieces& pieces, const ArcLength& lengths, double distance,
                                   Remainder remainder = Remainder::bare);

/// The places of `count` points (at least 2) at equal steps of length, from the start of the curve
/// to its end, one after the other: what `spread` gives, for those who need no spots. `places` has
/// room for count x dimension numbers; throws std::invalid_argument where it has not.
void spreadPlaces(const Pieces& pieces, const ArcLength& lengths, std::size_t count,
                  std::span<double> places);

/// `perPiece` equal steps of u on each piece: pieces * perPiece + 1 spots, the last one included.
std::vector<Spot> spreadPerPiece(const Pieces& pieces, std::size_t perPiece);

/// The samples at given spots.
std::vector<Sample> samplesAt(const Pieces& pieces, const ArcLength& lengths,
                              const std::vector<Spot>& spots);

} // namespace splineloft
