// Arc length: how long the curve is, and which spot lies how far along it.
#pragma once

#include "core/spline/piece.h"

#include <span>
#include <vector>

namespace splineloft {

/// The length of a curve with an absolute error of at most `tolerance`, in its unit of length; to
/// full precision where that is not above zero. Bounded work for any input. Lengths beyond the
/// largest double are that.
double lengthOf(const Pieces& pieces, double tolerance = 0);

/// Spots that follow each other on one piece.
struct SpotRun {
    std::size_t segment = 0;
    std::size_t count = 0;
};

/// Lengths of a curve, measured once: total, up to a spot, and back from length to spot. Each piece
/// is cut into panels on which 16-point Gauss quadrature of the speed has converged; near a cusp
/// the cutting stops where the rest is below rounding. Bounded work for any input.
///
/// Lengths hold for all weights that a curve may have. A spot is as near as its u can say: toward
/// u = 1, where numbers lie 1.1e-16 apart, a rational piece with weights as uneven as 1 to 1e9 runs
/// 1e9 times as fast as elsewhere, and the spots on it lie up to half such a step times the speed
/// off. Toward u = 0, where numbers are dense, they do not.
class ArcLength {
  public:
    /// Measures `pieces`, of which it keeps a reference. Relative error about 1e-14.
    explicit ArcLength(const Pieces& pieces);

    double total() const { return panels_.empty() ? 0 : panels_.back().lengthAtEnd; }
    /// Length from the start of the curve to a spot.
    double upTo(Spot spot) const;
    /// The spot at `length` from the start; the nearer end where it lies outside.
    Spot spotAt(double length) const;
    /// The same for many lengths that never fall: where they are close together, much quicker than
    /// one by one. The spots never fall either.
    std::vector<Spot> spotsAt(std::span<const double> lengths) const;
    /// The same in place: puts the u of its spot where each length was. Says which pieces the spots
    /// lie on, from the first to the last.
    std::vector<SpotRun> toParameters(std::span<double> lengths) const;

  private:
    struct Panel {
        std::size_t segment;
        /// Values of u; on the second half of a rational piece, where `start` is below zero, of
        /// u - 1, which says more exactly how far from the end they are.
        double start, end;
        double lengthAtStart, lengthAtEnd;

        bool isFromEnd() const { return start < 0; }
        double parameterAt(double u) const { return isFromEnd() ? u - 1 : u; }
    };

    void findOn(const Panel& panel, std::span<double> lengths) const;

    const Pieces* pieces_;
    std::vector<Panel> panels_;
};

} // namespace splineloft
