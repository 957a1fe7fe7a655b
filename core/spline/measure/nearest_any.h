// The nearest search on pieces of any degree, dimension and form, with coordinates of any size.
#pragma once

#include "core/spline/algebra/bernstein.h"
#include "core/spline/measure/nearest_search.h"

#include <vector>

namespace splineloft::nearest {

/// Measures are distances, in a unit that brings the coordinates near 1.
class AnySearch {
  public:
    AnySearch(const Pieces& pieces, const Point& place, double within);

    const Best& best() const { return best_; }
    double distance() const { return best_.measure() / scale_; }
    /// Lower bound of the distance: that of the Bézier points' box.
    double bound(std::size_t segment) const;
    /// Searches one piece.
    void look(std::size_t segment);

  private:
    /// A part of the piece, with the place at the origin.
    struct Part {
        std::vector<double> coordinates; ///< as Piece::coordinates
        double low = 0, high = 1;        ///< values of u
    };
    struct Pull;

    Piece pieceOf(const Part& part) const;
    Part seenFromPlace(std::size_t segment) const;
    void offer(double u);
    void branch(const Part& part);
    void settle(const Part& part, double start);
    void cut(const Part& part);

    const Pieces& pieces_;
    double scale_;
    double weightScale_;
    Point place_; // scaled
    Best best_;
    std::size_t segment_ = 0; ///< the piece that is searched
    Part whole_;              ///< all of it
    int cuts_ = 0;
};

} // namespace splineloft::nearest
