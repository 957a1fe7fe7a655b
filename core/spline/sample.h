// Points along a curve, for beads, travellers and export.
#pragma once

#include "core/spline/length.h"
#include "core/spline/piece.h"

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

/// `perPiece` equal steps of u on each piece: pieces * perPiece + 1 spots, the last one included.
std::vector<Spot> spreadPerPiece(const Pieces& pieces, std::size_t perPiece);

/// The samples at given spots.
std::vector<Sample> samplesAt(const Pieces& pieces, const ArcLength& lengths,
                              const std::vector<Spot>& spots);

} // namespace splineloft
