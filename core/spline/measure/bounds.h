// How far a curve reaches.
#pragma once

#include "core/spline/piece.h"

#include <optional>

namespace splineloft {

/// Corners of a box along the axes.
struct Box {
    Point low, high;
};

/// The box around all Bézier points, which contains the curve; nothing where there is no piece.
std::optional<Box> hullBox(const Pieces& pieces);

/// The smallest box that contains the curve: from the ends of the pieces and the spots at which a
/// coordinate stands still, which are the zeros of the hodograph. Nothing where there is no piece.
std::optional<Box> bounds(const Pieces& pieces);

} // namespace splineloft
