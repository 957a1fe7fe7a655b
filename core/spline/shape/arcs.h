// Arcs: stretches of a plane curve along which neither x nor y turns back, so that none of them can
// cross itself; and where two of them meet.
#pragma once

#include "core/spline/piece.h"

#include <array>
#include <optional>
#include <vector>

namespace splineloft {

/// A stretch of one piece, [low, high] in its u.
struct Arc {
    std::vector<double> bezier; ///< as `Piece::coordinates`, in the unit of `Arcs`
    std::size_t segment = 0;
    double low = 0, high = 1;
    std::array<double, 2> least{}, greatest{}; ///< corners of its box
    std::array<int, 2> runs{};                 ///< whether x and y rise (1), fall (-1) or stay (0)
    double rounding = 0;                       ///< of its coordinates
};

/// The arcs of a plane curve, in its order, in a unit in which no coordinate is above 1. Stretches
/// that do not get anywhere are left out.
std::vector<Arc> arcsOf(const Pieces& pieces);

/// The end of one arc that is the start of another, in a pair of arcs.
struct SharedEnds {
    bool secondFollows = false; ///< the first arc ends where the second starts
    bool firstFollows = false;  ///< the second arc ends where the first starts
};

/// Where two arcs meet: u of the pieces they belong to.
struct Meeting {
    double a = 0, b = 0;
};

/// All meetings of two arcs.
struct Meetings {
    std::vector<Meeting> all;
    bool coincide = false; ///< they run along each other; then none are named
    int looks = 0;         ///< pairs of stretches looked at
};

/// A stretch that two arcs have in common: where it starts and ends, of the way along each.
struct Overlap {
    std::array<double, 2> a{}, b{};
};

/// The stretch along which two arcs coincide within rounding, if there is one.
std::optional<Overlap> overlapOf(const Arc& a, const Arc& b, const Piece& shape);

/// Where two arcs meet, other than in the ends that they share. `shape` is any piece of the curve.
Meetings meetingsOf(const Arc& a, const Arc& b, SharedEnds shared, const Piece& shape);

} // namespace splineloft
