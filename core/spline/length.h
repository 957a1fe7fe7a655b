// Arc length: how long the curve is, and which spot lies how far along it.
#pragma once

#include "core/spline/piece.h"

#include <vector>

namespace splineloft {

/// Lengths of a curve, measured once: total, up to a spot, and back from length to spot. Each piece
/// is cut into panels on which 16-point Gauss quadrature of the speed has converged; near a cusp
/// the cutting stops where the rest is below rounding. Bounded work for any input.
class ArcLength {
  public:
    /// Measures `pieces`, of which it keeps a reference. Relative error about 1e-14.
    explicit ArcLength(const Pieces& pieces);

    double total() const { return panels_.empty() ? 0 : panels_.back().lengthAtEnd; }
    /// Length from the start of the curve to a spot.
    double upTo(Spot spot) const;
    /// The spot at `length` from the start; the nearer end where it lies outside.
    Spot spotAt(double length) const;

  private:
    struct Panel {
        std::size_t segment;
        double start, end; ///< values of u
        double lengthAtStart, lengthAtEnd;
    };

    class Survey;

    const Pieces* pieces_;
    std::vector<Panel> panels_;
};

} // namespace splineloft
