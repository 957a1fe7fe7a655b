// Places as the graphics card wants them: it has no doubles, so each number goes as a float and
// what that leaves out, another float. Together they have 48 bits: a view of a thousandth of a
// millionth of the document still has pixels to spare.
#pragma once

#include "core/spline/ranges.h"
#include "ui/drawing.h"

#include <array>
#include <vector>

namespace splineloft::ui {

/// A number as a float and the rest of it.
std::array<float, 2> split(double number);

/// Four floats a point: x, y, the rest of x, the rest of y.
std::vector<float> packed(std::span<const PlanePoint> points);

/// The points of a table that some blocks of its revisions stand for.
Range pointsOf(const PieceTable& table, const Range& blocks);

} // namespace splineloft::ui
