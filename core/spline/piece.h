// A piece: an interval of the parameter and the Bézier points of the curve over it. Whatever the
// family was, from here on there are only pieces.
#pragma once

#include "core/spline/ladder.h"
#include "core/spline/point.h"

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

/// A piece as seen through its Bézier points (degree + 1 of them).
struct Piece {
    std::span<const double> coordinates; ///< point after point
    int degree = 0;
    int dimension = 0;

    Point bezierPoint(int index) const;
    /// de Casteljau's construction at u.
    Ladder<Point> ladder(double u) const;
    Point position(double u) const;
    /// Derivatives are by u.
    Jet jet(double u) const;
    /// The derivative by u, itself a Bézier piece: its points are degree * (P[i+1] - P[i]).
    std::vector<double> hodograph() const;
};

/// All pieces of a curve, of one degree, in one block of memory.
class Pieces {
  public:
    Pieces() = default;
    /// `bezier` holds pieces x (degree + 1) x dimension coordinates.
    Pieces(int degree, int dimension, KnotLine knots, std::vector<double> bezier);

    std::size_t size() const { return knots_.pieces(); }
    bool empty() const { return size() == 0; }
    int degree() const { return degree_; }
    int dimension() const { return dimension_; }
    const KnotLine& knots() const { return knots_; }

    Piece operator[](std::size_t segment) const;
    Point position(Spot spot) const { return (*this)[spot.segment].position(spot.u); }
    /// Derivatives by u of the spot's piece.
    Jet jet(Spot spot) const { return (*this)[spot.segment].jet(spot.u); }
    /// Derivatives by the parameter t. On a piece of no interval they are those by u.
    Jet jetByParameter(Spot spot) const;

  private:
    int degree_ = 0;
    int dimension_ = 0;
    KnotLine knots_;
    std::vector<double> bezier_;
};

/// The same pieces, as recipes: each Bézier point is a blend of the controls.
class BlendPieces {
  public:
    BlendPieces() = default;
    /// `bezier` holds pieces x (degree + 1) blends; `controlPoints` is the number of control
    /// points.
    BlendPieces(int degree, std::size_t controlPoints, KnotLine knots, std::vector<Blend> bezier);

    std::size_t size() const { return knots_.pieces(); }
    int degree() const { return degree_; }
    std::size_t controlPoints() const { return controlPoints_; }
    const KnotLine& knots() const { return knots_; }

    /// The degree + 1 blends of one piece.
    std::span<const Blend> operator[](std::size_t segment) const;
    /// The basis functions at a spot, as the blend of controls that is the point of the curve.
    Blend basis(Spot spot) const;

  private:
    int degree_ = 0;
    std::size_t controlPoints_ = 0;
    KnotLine knots_;
    std::vector<Blend> bezier_;
};

} // namespace splineloft
