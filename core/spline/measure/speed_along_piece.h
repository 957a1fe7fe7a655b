// What is asked of the speed |P'(u)| along a piece, whatever the piece is.
#pragma once

#include "core/spline/measure/quadrature.h"

#include <concepts>
#include <cstddef>
#include <span>

namespace splineloft {

/// What the Bézier points of the hodograph over a panel say of the speed there.
struct SpeedHull {
    double fastest = 0; ///< the speed is nowhere above this
    /// The part of the mean velocity that is kept everywhere, in its own direction: far above zero
    /// there is no cusp nearby. Where the piece rests at an end of the panel, that end is left out,
    /// for it does not roughen the speed.
    double least = 0;
};

/// The hull of velocities in rows of `dimension` coordinates.
SpeedHull hullOf(std::span<const double> velocities, std::size_t dimension);

/// Differences of coordinates of any size are formed of sixteenths, so that they stay finite.
inline constexpr double sixteenth = 1.0 / 16;

/// The parameters between which a panel lies.
struct Stretch {
    double start = 0, end = 1;
};

/// A speed at the nodes of a panel, one after the other.
template <class Speed> gauss::Samples samplesOf(const Speed& speed, double middle, double half) {
    gauss::Samples samples;
    for (std::size_t i = 0; i < gauss::pairs; ++i) {
        samples.after[i] = speed.at(middle + half * gauss::nodes[i]);
        samples.before[i] = speed.at(middle - half * gauss::nodes[i]);
    }
    return samples;
}

/// The halves of a piece, to u = 1/2 and from there.
enum class Half { first, second };

/// The half on which a panel lies whose parameter begins at `start`: u on the first half, u - 1 on
/// the second.
inline Half halfOf(double start) {
    return start < 0 ? Half::second : Half::first;
}

/// What is asked of a speed. All numbers are in its `unit()`, which keeps squares from overflowing
/// and vanishing.
template <class S>
concept SpeedAlongPiece = requires(const S& speed, double u) {
    { speed.unit() } -> std::same_as<double>;
    { speed.size() } -> std::same_as<double>;   ///< the piece is no longer than a few of this
    { speed.range() } -> std::same_as<Stretch>; ///< of the parameter
    { speed.grain(u) } -> std::same_as<double>; ///< what the rounding of a parameter is part of
    { speed.at(u) } -> std::same_as<double>;
    { speed.on(u, u) } -> std::same_as<gauss::Samples>; ///< a panel by its middle and half width
    { speed.hullOn(u, u) } -> std::same_as<SpeedHull>;  ///< a panel by its ends
    { S::mostHalvings } -> std::convertible_to<std::size_t>; ///< of a panel
};

} // namespace splineloft
