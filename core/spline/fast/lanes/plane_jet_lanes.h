// Positions, derivatives and curvatures of a plane polynomial in one pass, compiled for every set
// of instructions.
#pragma once

#include <cstddef>

namespace splineloft::lanes {

/// One piece in the plane, in power form, and where to look at it.
struct PlaneJetTask {
    const double* coefficients = nullptr; ///< degree + 1 rows of two numbers, constants first
    int degree = 2;                       ///< 2 at least
    const double* u = nullptr;            ///< `count` values, and `runPadding` more
    std::size_t count = 0;
};

/// Writes pairs, pairs (by u) and single numbers: signed curvatures, 0 wherever there is none. The
/// speeds are of any size that a double has.
void planeJets(const PlaneJetTask& task, double* positions, double* firsts, double* curvatures);

} // namespace splineloft::lanes
