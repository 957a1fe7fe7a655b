// What is to be converted: the pieces of a curve and nothing of where they came from, brought into
// the form in which the other families are looked for.
#pragma once

#include "core/spline/curve.h"

#include <optional>
#include <vector>

namespace splineloft::conversion {

/// Places this close are one: a part of the extent of the pieces, and what rounding leaves of
/// numbers as large as their coordinates. A length.
double toleranceOf(const Pieces& pieces);

/// The pieces of a curve, to be found again in another family.
struct Shape {
    Pieces pieces; ///< of coordinates near 1, without weights where all of a piece are equal
    bool closed = false;
    int exponent = 0; ///< the curve is 2^exponent times as large
    double tolerance = 0;

    std::size_t size() const { return pieces.size(); }
    /// Joint number i, of which a closed curve has as many as pieces, an open one one more.
    Point joint(std::size_t i) const;
    /// Derivatives by u with which the curve leaves a joint and arrives there: at the two ends of
    /// an open curve both are the same one.
    Point leaving(std::size_t joint) const;
    Point arriving(std::size_t joint) const;
    /// Joints in all: see `joint`.
    std::size_t joints() const { return size() + (closed ? 0 : 1); }
    /// Whether a piece ends and another begins at the joint.
    bool isInner(std::size_t joint) const { return closed || (joint > 0 && joint < size()); }
    /// Whether all pieces have intervals of one length, and so may have the joints 0, 1, 2, ...
    bool isUniform() const;
};

/// The pieces as polynomials, if the weights are equal all along each of them.
Pieces withoutIdleWeights(const Pieces& pieces);

/// The shape of a curve. Powers of 2 keep its numbers from overflowing, so that nothing is rounded.
Shape shapeOf(const Pieces& pieces, bool closed);

/// The Bézier point as it is blended: times its weight and followed by it on a rational piece.
Point homogeneous(const Piece& piece, int index);

/// The same pieces, of a degree not below their own (Forrest 1972).
Pieces raised(const Pieces& pieces, int degree);

/// The same pieces as ones of lower degree, where they were raised from it.
std::optional<Pieces> lowered(const Pieces& pieces, int degree, double tolerance);

/// The same pieces in exactly this degree, where they have it.
std::optional<Pieces> ofDegree(const Pieces& pieces, int degree, double tolerance);

} // namespace splineloft::conversion
