// Round numbers along an axis.
#pragma once

#include <string>

namespace splineloft::ui {

/// The least distance of ticks that leaves them at least `apart` pixels from each other, where
/// `span` units take `pixels`: 1, 2 or 5 times a power of ten. Above zero for any span that is.
double tickStep(double span, double pixels, double apart);

/// Numbers that are too large or too small to be written at every tick share a power of a thousand.
struct Magnitude {
    double unit = 1;   ///< by which to divide
    std::string words; ///< "10³ ", to stand before the name of the unit; empty where it is one
};

/// The magnitude in which the ticks of an axis are written on which the largest number is
/// `largest`.
Magnitude magnitudeOf(double largest);

} // namespace splineloft::ui
