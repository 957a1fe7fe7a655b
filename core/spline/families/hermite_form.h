// The Hermite form of a cubic: where it begins and ends, and how fast it goes there. Several
// families only differ in how they choose the tangents.
#pragma once

#include "core/spline/blend.h"

#include <span>

namespace splineloft::families {

/// Bézier points of the cubic from `start` to `end` with the derivatives `leaving` and `arriving`
/// by u: a handle is a third of its tangent.
template <Blendable T>
void hermiteToBezier(const T& start, const T& leaving, const T& arriving, const T& end,
                     std::span<T> bezier) {
    bezier[0] = start;
    bezier[1] = start + (1.0 / 3.0) * leaving;
    bezier[2] = end - (1.0 / 3.0) * arriving;
    bezier[3] = end;
}

} // namespace splineloft::families
