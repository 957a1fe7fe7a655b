// How smoothly two pieces meet, measured on the pieces themselves.
#pragma once

#include "core/spline/piece.h"

#include <string>
#include <vector>

namespace splineloft {

/// What was measured at one joint. C counts derivatives by the parameter that agree, G the
/// geometric ones: direction of the tangent, then curvature. -1 means that the curve is broken
/// there.
struct Joint {
    double t = 0;           ///< parameter value (knot)
    std::size_t before = 0; ///< the piece that ends here
    std::size_t after = 0;  ///< the piece that begins here
    int c = 2;              ///< -1 .. 2
    int g = 2;              ///< -1 .. 2
    /// Sizes of the jumps of position, first and second derivative by t.
    double gap = 0, firstJump = 0, secondJump = 0;
    /// Jumps of the direction (radians, 0 .. pi) and of the curvature vector (1 / length).
    double turn = 0, curvatureJump = 0;
    /// Speed after the joint over speed before it; 1 where either is zero.
    double speedRatio = 1;
    bool atRest = false;    ///< the speed is zero on one side or both: no curvature to compare
    bool mayBeMore = false; ///< the degree allows more than C2, which is not measured
};

/// The joint at the end of piece `before`; at the end of the last, where a closed curve returns to
/// its start.
Joint jointAfter(const Pieces& pieces, std::size_t before);

/// All joints, in order; for a closed curve the last is the one where it returns to its start.
/// Pieces without interval (coincident points with chordal knots) are measured by their own u.
std::vector<Joint> jointsOf(const Pieces& pieces, bool closed);

/// In words, e.g. "G², not C²: the second derivative jumps by 3.1".
std::string describe(const Joint& joint);

/// Whether the words are the same for both; quick where both are smooth.
bool readAlike(const Joint& a, const Joint& b);

} // namespace splineloft
