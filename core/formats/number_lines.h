// Points as lines of numbers: as spreadsheets copy them, or as CSV.
#pragma once

#include "core/formats/result.h"
#include "core/spline/curve.h"

#include <string_view>

namespace splineloft {

/// One point a line, its coordinates parted by tabs, semicolons, commas or spaces; where tabs or
/// semicolons part them, a comma may stand for the decimal point. The first line may name the
/// coordinates. The curve is of the usual family. A refusal says at which line and column.
Result<Curve> curveFromLines(std::string_view text);

} // namespace splineloft
