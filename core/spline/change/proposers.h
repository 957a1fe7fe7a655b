// One proposer for each family: it offers the curves that might be the shape. Shapes come in the
// family's own degree, without weights unless the family has some.
#pragma once

#include "core/spline/change/trial.h"

namespace splineloft::conversion {

/// Families whose points and tangents lie on the pieces (on_the_pieces.cpp).
void proposeBezierSpline(const Shape& shape, Trial& trial);
void proposeHermite(const Shape& shape, Trial& trial);
void proposeBezier(const Shape& shape, Trial& trial);
void proposeLinear(const Shape& shape, Trial& trial);
void proposeParametricParabola(const Shape& shape, Trial& trial);
void proposeLagrange(const Shape& shape, Trial& trial);

/// Families that pass through the joints with tangents by a rule (by_tension.cpp, by_knobs.cpp).
void proposeCardinal(const Shape& shape, Trial& trial);
void proposeKochanekBartels(const Shape& shape, Trial& trial);
/// The same, with knots that follow the chords (by_chords.cpp).
void proposeCatmullRom(const Shape& shape, Trial& trial);
void proposeNatural(const Shape& shape, Trial& trial);

/// Families that approach their points, four for each piece (by_windows.cpp).
void proposeBcSpline(const Shape& shape, Trial& trial);
void proposeDuff(const Shape& shape, Trial& trial);
void proposeBeta(const Shape& shape, Trial& trial);

/// B-splines, rational ones too (by_knots.cpp).
void proposeBSpline(const Shape& shape, Trial& trial);

/// A measured value of a parameter: moved to the end of the range or the simple fraction that it
/// misses by rounding only. Rounding moves ends of the range more than others.
double tidied(double value, const Spline& spline, std::string_view key);

} // namespace splineloft::conversion
