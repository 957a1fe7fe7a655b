// A piece: an interval of the parameter and the Bézier points of the curve over it. Whatever the
// family was, from here on there are only pieces.
#pragma once

#include "core/spline/ladder.h"
#include "core/spline/point.h"
#include "core/spline/ranges.h"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace splineloft {

/// A spot on a curve: which piece, and how far along it (0 <= u <= 1).
struct Spot {
    std::size_t segment = 0;
    double u = 0;
    bool operator==(const Spot&) const = default;
};

/// The pieces lie between the knots: piece i covers [knots[i], knots[i + 1]].
class KnotLine {
  public:
    KnotLine() = default;
    /// `knots` has one more entry than there are pieces, and never falls.
    explicit KnotLine(std::vector<double> knots) : knots_(std::move(knots)) {}

    std::span<const double> knots() const { return knots_; }
    std::size_t pieces() const { return knots_.empty() ? 0 : knots_.size() - 1; }
    double start() const { return knots_.front(); }
    double end() const { return knots_.back(); }
    /// Length of the interval of piece `segment`; 0 where control points coincide.
    double interval(std::size_t segment) const { return knots_[segment + 1] - knots_[segment]; }

    /// Puts other knots in the place of those from number `first` on.
    void move(std::size_t first, std::span<const double> knots);

    /// Where parameter value t lies. A joint belongs to the piece that begins there, the end to the
    /// last piece; values outside are moved to the nearer end.
    Spot locate(double t) const;
    /// The parameter value of a spot.
    double parameter(Spot spot) const;

  private:
    std::vector<double> knots_;
};

/// Position and derivatives of a curve at one spot.
struct Jet {
    Point position;
    Point first;  ///< derivative of the position
    Point second; ///< second derivative
    /// Curvature, 1 / unit of length; signed in the plane (left turns are positive), not negative
    /// elsewhere. Nothing where the speed is zero, or where it is too slow for a finite number.
    std::optional<double> curvature;
};

/// What Bézier points are made of.
enum class Form {
    polynomial, ///< coordinates
    rational    ///< homogeneous coordinates: each times the point's weight, and the weight itself
};

/// A piece as seen through its Bézier points (degree + 1 of them). A rational piece is the
/// projection of a polynomial one with one coordinate more; all its weights are above zero.
struct Piece {
    std::span<const double> coordinates; ///< point after point, `width` numbers each
    int degree = 0;
    int dimension = 0; ///< of the space
    Form form = Form::polynomial;

    /// Numbers that a Bézier point takes in `coordinates`.
    int width() const { return dimension + (form == Form::rational ? 1 : 0); }
    /// The place of a Bézier point.
    Point bezierPoint(int index) const;
    /// Its weight; 1 on a polynomial piece.
    double weight(int index) const;
    /// One of the `width` numbers of every Bézier point: Bernstein coefficients.
    std::vector<double> column(int coordinate) const;
    /// de Casteljau's construction at u. On a rational piece its points are the projections, which
    /// lie on the legs as well, though no longer u of the way along (Farin 1983).
    Ladder<Point> ladder(double u) const;
    Point position(double u) const;
    /// Derivatives are by u.
    Jet jet(double u) const;
};

/// All pieces of a curve, of one degree, in one block of memory.
class Pieces {
  public:
    Pieces() = default;
    /// `bezier` holds pieces x (degree + 1) x width numbers, as `Piece::coordinates`.
    Pieces(int degree, int dimension, KnotLine knots, std::vector<double> bezier,
           Form form = Form::polynomial);

    std::size_t size() const { return knots_.pieces(); }
    bool empty() const { return size() == 0; }
    int degree() const { return degree_; }
    int dimension() const { return dimension_; }
    Form form() const { return form_; }
    const KnotLine& knots() const { return knots_; }
    /// The Bézier points of all pieces, piece after piece.
    std::span<const double> bezier() const { return bezier_; }

    Piece operator[](std::size_t segment) const;

    /// Some of the pieces, with their knots.
    Pieces part(const Range& range) const;
    /// Puts other Bézier points in the place of those from piece `first` on.
    void overwrite(std::size_t first, std::span<const double> bezier);
    /// Puts other knots in the place of those from number `first` on.
    void moveKnots(std::size_t first, std::span<const double> knots) { knots_.move(first, knots); }

    Point position(Spot spot) const { return (*this)[spot.segment].position(spot.u); }
    /// Derivatives by u of the spot's piece.
    Jet jet(Spot spot) const { return (*this)[spot.segment].jet(spot.u); }
    /// Derivatives by the parameter t. On a piece of no interval they are those by u.
    Jet jetByParameter(Spot spot) const;

  private:
    int degree_ = 0;
    int dimension_ = 0;
    Form form_ = Form::polynomial;
    KnotLine knots_;
    std::vector<double> bezier_;
};

/// The same pieces, as recipes: each Bézier point is a blend of the controls.
class BlendPieces {
  public:
    BlendPieces() = default;
    /// `bezier` holds pieces x (degree + 1) blends; `controlPoints` is the number of control
    /// points. In rational form a blend comes times its weight, which is the sum of its shares.
    BlendPieces(int degree, std::size_t controlPoints, KnotLine knots, std::vector<Blend> bezier,
                Form form = Form::polynomial);

    std::size_t size() const { return knots_.pieces(); }
    int degree() const { return degree_; }
    std::size_t controlPoints() const { return controlPoints_; }
    const KnotLine& knots() const { return knots_; }

    /// The degree + 1 blends of one piece. In rational form they are the places of the Bézier
    /// points, not times the weights.
    std::span<const Blend> operator[](std::size_t segment) const;
    /// The weights of the Bézier points of one piece; none in polynomial form.
    std::span<const double> weights(std::size_t segment) const;
    /// The basis functions at a spot, as the blend of controls that is the point of the curve.
    Blend basis(Spot spot) const;

  private:
    int degree_ = 0;
    std::size_t controlPoints_ = 0;
    KnotLine knots_;
    std::vector<Blend> bezier_;
    std::vector<double> weights_; // one a blend; none in polynomial form
};

} // namespace splineloft
