// Curves in long double, written from their definitions and without the library: what is right.
#pragma once

#include <cstdint>
#include <random>
#include <span>
#include <vector>

namespace splineloft::bench {

/// Numbers that are the same on every machine.
class Dice {
  public:
    explicit Dice(std::uint32_t seed) : engine_(seed) {}
    /// 0 <= number < 1.
    double part() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
    double between(double low, double high) { return low + (high - low) * part(); }
    /// `count` numbers.
    std::vector<double> between(std::size_t count, double low, double high);

  private:
    std::mt19937_64 engine_;
};

/// Value and derivatives of one coordinate.
struct Taylor {
    long double value = 0, first = 0, second = 0;
};

/// One coordinate of the uniform Catmull-Rom piece between p[1] and p[2] (Catmull and Rom 1974).
/// `stride` is the distance between its values at p[0] and p[1].
Taylor catmullRom(const double* p, std::size_t stride, long double u);

/// One coordinate of a Bézier piece by de Casteljau's construction.
Taylor bezier(const double* p, std::size_t stride, int degree, long double u);

/// One coordinate of a B-spline in piece `piece` (its degree-th knot interval and those after), by
/// de Boor's triangle.
long double deBoor(const double* points, std::size_t stride, std::span<const double> knots,
                   int degree, std::size_t piece, long double t);

/// Length of a plane cubic Bézier piece from u = 0 to `end`, to about 1e-16 of it or better:
/// 16-point Gauss panels, halved until both halves agree with the whole.
long double cubicLength(const double* bezier, long double end = 1);

/// The natural spline through y over rising x.
class NaturalReference {
  public:
    NaturalReference(std::span<const double> x, std::span<const double> y);
    long double at(double x) const;
    /// The slopes at the first and last points.
    long double slopeAtStart() const;
    long double slopeAtEnd() const;

  private:
    std::span<const double> x_, y_;
    std::vector<long double> second_; ///< second derivatives at the points
};

/// Bézier points of the pieces of a plane or spatial uniform Catmull-Rom spline, rounded to double.
std::vector<double> bezierOfCatmullRom(std::span<const double> points, int dimension);

/// Bézier points of the pieces of a clamped cubic B-spline in the plane, rounded to double.
std::vector<double> bezierOfCubicBSpline(std::span<const double> points,
                                         std::span<const double> knots);

/// Knots 0 (degree + 1 times), 1, 2, ..., pieces (degree + 1 times).
std::vector<double> clampedKnots(std::size_t pieces, int degree);

} // namespace splineloft::bench
