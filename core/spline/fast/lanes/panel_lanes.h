// Where quadrature of a plane cubic's speed has to be careful, known beforehand; compiled for every
// set of instructions.
//
// In the plane, a point is a complex number and a cubic's hodograph is h(u) = c (u - r)(u - s). Its
// size, the speed, is smooth except at the complex numbers r, s and their conjugates. A panel of
// Gauss quadrature with n nodes errs by about rho^(-2n), where rho belongs to the largest ellipse
// around the panel that holds no such point (Bernstein 1912; Trefethen 2008, theorem 4.5). So the
// largest panel that is good enough follows from r and s alone, by a quadratic equation.
#pragma once

#include "core/spline/fast/lanes/speed_lanes.h"

#include <array>
#include <cstddef>

namespace splineloft::lanes {

/// How many nodes a rule has.
enum class Nodes { sixteen, thirtyTwo };

/// Panels one after the other, from u = 0 to u = 1.
struct Panels {
    static constexpr std::size_t most = 400;

    std::size_t count = 0;
    std::array<double, most + 1> joints; ///< their ends, from joints[0] = 0 to joints[count] = 1

    std::span<const double> all() const { return std::span(joints).first(count + 1); }
};

/// Cuts [0, 1] into as few panels as can be, on each of which the integral of the speed by so many
/// nodes errs by no more than `tolerance`. The velocity has 2 dimensions, or 1 and a second
/// coordinate of zero.
void cutIntoPanels(const Parabola& velocity, double tolerance, Nodes nodes, Panels& panels);

} // namespace splineloft::lanes
