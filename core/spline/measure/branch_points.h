// Where quadrature of a plane cubic's speed has to be careful, known beforehand.
//
// In the plane, a point is a complex number and a cubic's hodograph is h(u) = c (u - r)(u - s). Its
// size, the speed, is smooth except at the complex numbers r, s and their conjugates. A panel of
// Gauss quadrature with n nodes errs by about rho^(-2n), where rho belongs to the largest ellipse
// around the panel that holds no such point (Bernstein 1912; Trefethen 2008, theorem 4.5). So the
// largest panel that is good enough follows from r and s alone, by a quadratic equation.
#pragma once

#include <array>
#include <complex>
#include <cstddef>

namespace splineloft {

/// The points off which the size of a complex parabola is smooth.
class BranchPoints {
  public:
    BranchPoints() = default;
    /// Those of |a + b u + c u^2|.
    BranchPoints(std::complex<double> a, std::complex<double> b, std::complex<double> c);

    /// The end, at most 1, of the longest panel from `start` on which the integral by 16 points
    /// errs by no more than `tolerance`.
    double panelEnd(double start, double tolerance) const;

  private:
    struct BranchPoint {
        double u = 0;      ///< where it lies beside the line of parameters
        double height = 0; ///< how far off that line, not below zero
    };

    void add(std::complex<double> root);

    std::array<BranchPoint, 2> points_;
    std::size_t count_ = 0;
    double strength_ = 0; // how fast the speed grows with the distance from a branch point, at most
};

} // namespace splineloft
