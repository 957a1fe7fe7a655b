// Where a curve turns in a special way: to the other side, not at all for want of speed, or most or
// least of all around.
#pragma once

#include "core/spline/piece.h"

#include <vector>

namespace splineloft {

/// The inflections of a plane curve: the spots at which its curvature changes sign, in order. They
/// are zeros of the Bernstein polynomial P' x P'' (of the determinant of the homogeneous point and
/// its first two derivatives on a rational piece). Where the sign changes from one piece to the
/// next, the joint is reported, once, as the start of the later piece; that includes the start of a
/// curve that ends where it starts. Where a straight stretch lies between, its far end is reported.
/// A cusp is none: curvature is infinite there and of one sign. Straight curves have none, however
/// they run to and fro, and so have curves of another dimension than 2.
std::vector<Spot> inflections(const Pieces& pieces);

/// The spots of zero speed, in order: cusps, turning points of curves that run back on themselves,
/// and ends whose handle lies on them. Zero means not above 1e-9 of the piece's largest leg times
/// its degree, or what rounding of its coordinates leaves. They are zeros of the derivative of the
/// squared speed, because those of the speed itself are double and vanish with the slightest
/// rounding. A joint is reported once, as the start of the later piece. Pieces that do not move at
/// all are passed over. Any dimension.
std::vector<Spot> cusps(const Pieces& pieces);

/// The vertices of a plane curve: the spots inside of pieces at which the curvature is largest or
/// least of all around, in order. Circles and lines have none.
std::vector<Spot> vertices(const Pieces& pieces);

} // namespace splineloft
