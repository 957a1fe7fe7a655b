// Numbers without the dust that decimals leave behind when they are added in binary.
#pragma once

namespace splineloft {

/// The value to 14 significant digits.
double tidied(double value);

/// a + b to 14 significant digits; a itself where b is nothing.
inline double cleanSum(double a, double b) {
    return b == 0 ? a : tidied(a + b);
}

} // namespace splineloft
