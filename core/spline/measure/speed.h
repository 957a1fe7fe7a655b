// The speed |P'(u)| along one piece, as quadrature samples it.
#pragma once

#include "core/spline/fast/lanes/panel_lanes.h"
#include "core/spline/fast/lanes/speed_lanes.h"
#include "core/spline/measure/quadrature.h"
#include "core/spline/measure/rational_speed.h"
#include "core/spline/measure/speed_along_piece.h"
#include "core/spline/piece.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace splineloft {

/// Speed of a polynomial piece of degree 0 to 3 in few dimensions: its hodograph is the parabola
/// a + b u + c u^2. Allocates nothing.
template <int dimension> class ParabolaSpeed {
  public:
    static constexpr std::size_t mostHalvings = 64;

    explicit ParabolaSpeed(const Piece& piece);

    double unit() const { return unit_; }
    double size() const { return size_; }
    static Stretch range() { return {}; }
    static double grain(double) { return 1; }

    double at(double u) const {
        double sum = 0;
        for (std::size_t k = 0; k < coordinates; ++k) {
            const double h = velocity(k, u);
            sum += h * h;
        }
        return std::sqrt(sum);
    }

    gauss::Samples on(double middle, double half) const {
        gauss::Samples samples;
        lanes::sampleSpeeds(velocity_, middle, half, gauss::nodes, samples);
        return samples;
    }

    /// The integral over all panels between `joints`, on each of which the wide rule is good.
    double integralOver(std::span<const double> joints) const {
        return lanes::integrateSpeed(velocity_, gauss::wide, joints);
    }

    SpeedHull hullOn(double start, double end) const {
        std::array<double, 3 * coordinates> velocities;
        const double half = 0.5 * (end - start);
        for (std::size_t k = 0; k < coordinates; ++k) {
            const double from = velocity(k, start);
            velocities[k] = from;
            velocities[coordinates + k] =
                from + half * (velocity_.b[k] + 2 * start * velocity_.c[k]);
            velocities[2 * coordinates + k] = velocity(k, end);
        }
        return hullOf(velocities, coordinates);
    }

    /// Cuts the piece, on a line or in the plane, into panels on which quadrature with so many
    /// nodes is good.
    void cut(double tolerance, lanes::Nodes nodes, lanes::Panels& panels) const
        requires(dimension <= 2)
    {
        lanes::cutIntoPanels(velocity_, tolerance, nodes, panels);
    }

  private:
    static constexpr std::size_t coordinates{dimension};

    double velocity(std::size_t k, double u) const {
        const auto& [a, b, c, size] = velocity_;
        return a[k] + u * (b[k] + u * c[k]);
    }

    lanes::Parabola velocity_{.dimension = coordinates};
    double unit_ = 16;
    double size_ = 0;
};

/// Speed of any polynomial piece, by de Casteljau's construction on its hodograph.
class LadderSpeed {
  public:
    static constexpr std::size_t mostHalvings = 64;

    explicit LadderSpeed(const Piece& piece);

    double unit() const { return unit_; }
    double size() const { return size_; }
    static Stretch range() { return {}; }
    static double grain(double) { return 1; }
    double at(double u) const;
    gauss::Samples on(double middle, double half) const;
    SpeedHull hullOn(double start, double end) const;

  private:
    void climbAll(std::span<double> rungs, double u) const;

    std::vector<double> coordinates_; // of the hodograph's Bézier points, in units
    mutable std::vector<double> rungs_;
    std::size_t dimension_;
    double unit_ = 1;
    double size_ = 0;
};

/// Calls `visit` with the quickest speed for the piece; for the half of it, where it is rational.
template <class Visit> auto withSpeed(const Piece& piece, Half half, Visit&& visit) {
    if (piece.form == Form::rational) {
        return visit(RationalSpeed(piece, half));
    }
    if (piece.degree <= 3) {
        switch (piece.dimension) {
        case 1: return visit(ParabolaSpeed<1>(piece));
        case 2: return visit(ParabolaSpeed<2>(piece));
        case 3: return visit(ParabolaSpeed<3>(piece));
        default: break;
        }
    }
    return visit(LadderSpeed(piece));
}

/// Calls `visit` with the speed of the whole piece, or of one half after the other.
template <class Visit> void withSpeeds(const Piece& piece, Visit visit) {
    withSpeed(piece, Half::first, visit);
    if (piece.form == Form::rational) {
        withSpeed(piece, Half::second, visit);
    }
}

/// Length, in units, of the part from u = start to u = end, on which the speed is smooth.
template <SpeedAlongPiece Speed> double integral(const Speed& speed, double start, double end) {
    const double half = 0.5 * (end - start);
    return half * gauss::integralOf(speed.on(0.5 * (start + end), half));
}

} // namespace splineloft
