// Work on columns of samples (one coordinate of many samples each), compiled for every set of
// instructions: what is left to do where points are not written at once.
#pragma once

#include <cstddef>

namespace splineloft::lanes {

/// Columns of equally many samples. Each may be read and written up to its stride.
struct Columns {
    double* first = nullptr; ///< the first column
    std::size_t stride = 0;  ///< from column to column; at least `samples` and `runPadding`
    std::size_t samples = 0;
    int dimension = 0; ///< columns; where homogeneous, one more follows: the weight

    double* operator[](int column) const {
        return first + static_cast<std::size_t>(column) * stride;
    }
};

/// From homogeneous coordinates to places.
void projectPositions(const Columns& positions);
/// The same for positions and two derivatives, by the quotient rule.
void projectJets(const Columns& positions, const Columns& firsts, const Columns& seconds);

/// Curvature from two derivatives: signed in the plane, otherwise its norm; 0 where the speed is 0
/// or the curvature is not finite.
void curvaturesOf(const Columns& firsts, const Columns& seconds, double* curvatures);

/// Writes the samples row after row.
void weave(const Columns& columns, double* out);
void weave(const Columns& columns, float* out);

} // namespace splineloft::lanes
