// A curve made ready to be asked for points here and there: coefficients formed once and kept, and
// the piece found without searching through the knots.
#pragma once

#include "core/spline/piece.h"

#include <memory>
#include <span>

namespace splineloft {

/// The pieces of a curve as polynomials in Horner's form (see lanes/horner.h): in powers of u up to
/// degree 5, in scaled Bernstein form above. Keeps all it needs, about as much as the pieces.
///
/// In units of the largest Bézier coordinate of the piece (on a rational piece, times the ratio of
/// its weights), points are within 1e-13 of the exact value, cubics within 1e-14. In power form
/// u = 0 gives the Bézier point itself, u = 1 only to rounding.
class PowerForm {
  public:
    /// Throws std::invalid_argument if there are no pieces.
    explicit PowerForm(const Pieces& pieces);

    int dimension() const;
    /// The position at parameter value t; t outside the knots is moved to the nearer end, and NaN
    /// to the start.
    Point position(double t) const;
    /// The same into `dimension` numbers. Throws std::invalid_argument if `out` has another size.
    void position(double t, std::span<double> out) const;
    /// Positions at many t in any order, row after row: many at once are several times as fast.
    /// Throws std::invalid_argument if `out` has another size than t.size() x dimension.
    void positions(std::span<const double> t, std::span<double> out) const;

  private:
    struct Kept;

    std::shared_ptr<const Kept> kept_; ///< never changes: copies share it
};

} // namespace splineloft
