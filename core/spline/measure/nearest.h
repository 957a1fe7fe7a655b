// The spot of a curve nearest to a given place.
#pragma once

#include "core/spline/piece.h"

#include <limits>
#include <memory>
#include <optional>

namespace splineloft {

class ThickChords;

/// The closest spot and how far away it is.
struct Nearest {
    Spot spot;
    double distance = 0;
};

/// The nearest spot of all pieces, if it is nearer than `within`; nothing where there is no piece,
/// and nothing is nearer than a negative distance. Exact up to the rounding of positions, that is,
/// to about 1e-15 of the farthest coordinate of any piece; of equally near spots, the first one
/// found. Takes time for every piece, which is passed over where its hull lies farther away than
/// the best spot so far: for one question to a curve. For many, make a NearestIndex. `place` has
/// the curve's number of coordinates; nothing is near one that is not finite.
std::optional<Nearest> nearestTo(const Pieces& pieces, const Point& place,
                                 double within = std::numeric_limits<double>::infinity());

/// Answers the same question again and again, after looking at every piece once: a query takes
/// time like the logarithm of the number of pieces.
class NearestIndex {
  public:
    /// Keeps a reference to `pieces`.
    explicit NearestIndex(const Pieces& pieces);

    /// As nearestTo.
    std::optional<Nearest> nearest(const Point& place,
                                   double within = std::numeric_limits<double>::infinity()) const;

  private:
    const Pieces* pieces_;
    std::shared_ptr<const ThickChords> chords_; ///< never changes: copies share it
};

} // namespace splineloft
