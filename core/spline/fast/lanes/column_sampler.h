// Samples of one piece after another, in columns: one coordinate of many samples side by side. It
// suits what is done with points before they are written: division by weights, curvature.
#pragma once

#include "core/spline/fast/lanes/column_lanes.h"
#include "core/spline/fast/lanes/horner.h"
#include "core/spline/piece.h"

#include <cstddef>
#include <vector>

namespace splineloft::lanes {

/// The columns of one derivative (0, 1 or 2) of the pieces by u, homogeneous on rational pieces.
class ColumnSampler {
  public:
    /// Samples at most at a time.
    static constexpr std::size_t mostSamples = 256;

    /// Keeps a reference to `pieces`, whose degree is at most `mostScaledDegree`.
    ColumnSampler(const Pieces& pieces, int derivative, std::size_t perPiece);

    /// From now on samples are of this piece.
    void choosePiece(std::size_t piece);
    /// Samples u = k / perPiece for `begin` <= k < `end`, at most `mostSamples` of them. The
    /// columns are good until the next call.
    const Columns& sample(std::size_t begin, std::size_t end);

  private:
    const Pieces& pieces_;
    std::size_t width_; ///< columns, the weight included
    int derivative_;
    CoefficientMaker maker_; ///< of the derivative's degree
    std::vector<Run<double>> runs_;
    std::vector<double> legs_; ///< Bernstein coefficients of the derivative, point after point
    std::vector<double> coefficients_, values_;
    Columns columns_;
};

} // namespace splineloft::lanes
