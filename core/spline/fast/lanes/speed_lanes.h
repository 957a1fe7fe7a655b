// Speeds along pieces whose hodograph is a parabola, as quadrature asks for them, compiled for
// every set of instructions.
#pragma once

#include <array>
#include <cstddef>
#include <span>

namespace splineloft::lanes {

/// Eight numbers.
using Eight = std::array<double, 8>;

/// The velocity a + b u + c u^2. Coordinates beyond the dimension, which is 1 to 3, are not read.
struct Parabola {
    std::array<double, 3> a{}, b{}, c{};
    std::size_t dimension = 0;
};

/// Numbers at places in pairs, +x and -x.
struct EightPairs {
    Eight after;  ///< at +x
    Eight before; ///< at -x
};

/// The speeds at u = middle + half x and middle - half x for each x.
void sampleSpeeds(const Parabola& velocity, double middle, double half, const Eight& x,
                  EightPairs& speeds);

/// A rule of quadrature on [-1, 1] with 32 nodes: the positive ones and their weights.
struct WideRule {
    std::array<double, 16> nodes, weights;
};

/// The sum of the integrals of the speed between one joint and the next, by the rule on each.
double integrateSpeed(const Parabola& velocity, const WideRule& rule,
                      std::span<const double> joints);

} // namespace splineloft::lanes
