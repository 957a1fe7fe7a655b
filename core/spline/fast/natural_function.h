// The natural cubic spline of a function: the smoothest y(x) through given values, of all the one
// that bends least. For tables of measurements; curves that people draw are the family "natural".
#pragma once

#include "core/spline/fast/piece_table.h"

#include <cstddef>
#include <span>
#include <vector>

namespace splineloft {

/// A function through the points (x[i], y[i]): cubic between them, with continuous second
/// derivatives, which vanish at both ends. Outside it goes on straight with the slope of the end,
/// which keeps all that: value, slope and second derivative stay continuous. Values of any size are
/// welcome, up to the limits of a double; intervals may differ 10^100-fold.
/// Source: Ahlberg, Nilson and Walsh 1967; the equations are those of the slopes.
class NaturalFunction {
  public:
    /// Through `y.size()` points, at least 2; x rises. Both are copied. O(n), a few ns a point.
    /// Throws std::invalid_argument where a value is not finite, x does not rise, intervals
    /// are too uneven, or the sizes do not fit, with what would be right.
    NaturalFunction(std::span<const double> x, std::span<const double> y);

    /// Takes other points instead, in the memory of these; as the constructor, but where that
    /// throws, nothing changes.
    void refit(std::span<const double> x, std::span<const double> y);

    std::size_t size() const { return size_; }

    /// Value at x, in units of y. O(1) where the points are not extremely uneven, else O(log n).
    double operator()(double x) const;
    /// First derivative at x, in units of y by x.
    double derivative(double x) const;
    /// Second derivative at x, in units of y by x squared; 0 outside.
    double second(double x) const;
    /// Second derivative at point i.
    double secondAt(std::size_t i) const;
    /// Integral from a to b, in units of x times y; negative where b < a and y > 0. O(pieces
    /// between).
    double integral(double a, double b) const;

    /// The values at all of `x`, in any order, into `out`: the same numbers as one by one,
    /// usually sooner. Throws std::invalid_argument where the two are not equally long.
    void evaluate(std::span<const double> x, std::span<double> out) const;

  private:
    /// Where a value of x lies: beyond an end, the place is that end.
    struct Place {
        std::size_t piece;
        double x;      ///< within the piece
        double beyond; ///< how far outside
    };

    std::span<const double> xs() const { return {values_.data(), size_}; }
    std::span<const double> ys() const { return {values_.data() + size_, size_}; }
    std::span<const double> slopes() const { return {values_.data() + 2 * size_, size_}; }

    void normalize(std::span<const double> x, std::span<const double> y, bool isModest);
    void bring(std::span<const double> x, std::span<const double> y, std::size_t first);
    std::size_t towards(double x, std::size_t piece, std::size_t step) const;
    Place clamp(double x) const;
    Place locate(double x) const;
    double interval(std::size_t piece) const { return xs()[piece + 1] - xs()[piece]; }
    double chordSlope(std::size_t piece) const;
    double valueAt(const Place& place) const;
    double scaledSecondAt(std::size_t i) const;
    double integralWithin(std::size_t piece, double x) const;
    double integralBeyond(const Place& place) const;

    // Points in units of 2^xExponent_ and 2^yExponent_, which are 1 unless values are extreme.
    // All x, then all y, then the slopes at the points: in one block, which allocators give back to
    // the system more rarely than three.
    std::vector<double> values_;
    std::size_t size_ = 0;
    int xExponent_ = 0, yExponent_ = 0;
    double xFactor_ = 1, yFactor_ = 1; ///< into our units of x; out of our units of y

    PieceTable table_;
};

} // namespace splineloft
