// The equations of the natural cubic spline of a function.
#pragma once

#include <span>

namespace splineloft {

/// The slopes that a natural cubic spline through the points (x[i], y[i]) has there, into `slopes`;
/// all three equally long, at least 2; x rises, and differences of x and of y are finite. O(n).
void solveNaturalSlopes(std::span<const double> x, std::span<const double> y,
                        std::span<double> slopes);

} // namespace splineloft
