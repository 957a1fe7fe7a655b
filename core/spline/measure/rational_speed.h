// The speed along one half of a rational piece.
//
// P' = N / w^2 with N = sum over i < j of (j - i) B_i B_j w_i w_j (P_j - P_i) / (u (1 - u)), which
// is of degree 2d - 2 (after Floater 1992). Nothing cancels in it but what turns back, however
// uneven the weights are. They may keep all that happens within 1e-19 of an end, where next to 1
// there is no u: so each half is measured from its own end.
#pragma once

#include "core/spline/measure/speed_along_piece.h"
#include "core/spline/piece.h"

#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace splineloft {

/// Speed of half a rational piece. Its parameter is u on the first half and u - 1 on the second.
class RationalSpeed {
  public:
    /// A panel [0, x] is halved so often, at most: beyond the narrowest peak.
    static constexpr std::size_t mostHalvings = 96;

    RationalSpeed(const Piece& piece, Half half);

    double unit() const { return unit_; }
    double size() const { return size_; }
    Stretch range() const { return half_ == Half::first ? Stretch{0, 0.5} : Stretch{-0.5, 0}; }
    double grain(double u) const { return std::abs(u); }
    double at(double u) const;
    gauss::Samples on(double middle, double half) const;
    /// None is left of the velocity where weights are so uneven that samples might miss a peak.
    SpeedHull hullOn(double start, double end) const;

  private:
    void formVelocities(std::span<const double> places);
    double sizeOf(std::span<const double> places) const;

    Half half_;
    std::size_t dimension_, velocityCount_ = 1;
    // From the half's own end. Bernstein coefficients; those of the velocity, coordinate after
    // coordinate. And the same times binomial coefficients: powers of u / (1 - u).
    std::vector<double> weights_, velocities_;
    std::vector<double> weightPowers_, velocityPowers_;
    double unit_ = 1;
    double size_ = 0;
};

} // namespace splineloft
