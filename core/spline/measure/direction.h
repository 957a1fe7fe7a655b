// Which way a curve runs, also where it rests.
#pragma once

#include "core/spline/piece.h"

#include <optional>

namespace splineloft {

/// A vector as a unit vector; nothing where it has no direction or no finite length.
std::optional<Point> directionOf(const Point& vector);

/// The unit tangent of a piece at u. Where the derivative vanishes it is the limit from one side:
/// toward the first Bézier point of the larger part of the piece, as de Casteljau divides it at u,
/// that differs from the place at u by more than rounding. Nothing on a piece that does not move.
std::optional<Point> tangentAt(const Piece& piece, double u);

} // namespace splineloft
