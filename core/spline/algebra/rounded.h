// Polynomials that know their rounding. Whether a coefficient is zero can only be asked together
// with how exactly it is known; so sums and products carry a bound of that along.
#pragma once

#include "core/spline/algebra/bernstein.h"
#include "core/spline/piece.h"

#include <vector>

namespace splineloft {

/// A polynomial in Bernstein form, each of whose coefficients may be off by `rounding`.
struct Rounded {
    Bernstein coefficients;
    double rounding = 0;

    /// 1, -1, or 0 where the value at u cannot be told from zero.
    int signAt(double u) const;
    /// Nothing of it can be told from zero.
    bool isZero() const;
    /// Its zeros in [0, 1], in order.
    std::vector<double> roots() const;
};

Rounded product(const Rounded& a, const Rounded& b);
/// a + factor * b; the one of lower degree is raised to the other's.
Rounded sum(const Rounded& a, const Rounded& b, double factor = 1);
Rounded derivative(const Rounded& a);
/// Divided by a power of two, so that the largest coefficient is near 1.
Rounded scaled(Rounded a);

/// A piece seen from a place, in units of about its own size: that neither overflows nor
/// underflows, and keeps the digits that a far-off origin would cost.
struct LocalPiece {
    std::vector<Rounded> coordinates; ///< of the way from the place, times the weight
    Rounded weight;                   ///< at most 1; the constant 1 on a polynomial piece
    Form form = Form::polynomial;

    /// The derivative by u of a coordinate, times the weight squared.
    Rounded velocity(int coordinate) const;
};

LocalPiece localPiece(const Piece& piece, const Point& place);

} // namespace splineloft
