#include "core/spline/fast/lanes/column_sampler.h"

#include "core/spline/fast/lanes/dense_lanes.h"

#include <algorithm>

namespace splineloft::lanes {

ColumnSampler::ColumnSampler(const Pieces& pieces, int derivative, std::size_t perPiece)
    : pieces_(pieces),
      width_(static_cast<std::size_t>(pieces.dimension()) + (pieces.form() == Form::rational)),
      derivative_(derivative), maker_(std::max(pieces.degree() - derivative, 0)),
      runs_(runsOf(maker_.degree(), perPiece)),
      coefficients_(width_ * coefficientCount(maker_.degree())),
      values_(width_ * (mostSamples + runPadding)),
      columns_{values_.data(), mostSamples + runPadding, 0, pieces.dimension()} {}

void ColumnSampler::choosePiece(std::size_t piece) {
    const auto numbers = static_cast<std::size_t>(pieces_.degree() + 1) * width_;
    const auto bezier = pieces_.bezier().subspan(piece * numbers, numbers);
    legs_.assign(bezier.begin(), bezier.end());
    for (int d = 0; d < derivative_; ++d) {
        // The derivative of degree n has the legs of the polygon, times n; that of a constant is 0.
        const double n = std::max(pieces_.degree() - d, 0);
        const auto left = std::max(legs_.size() - width_, width_);
        for (std::size_t i = 0; i < left; ++i) {
            const auto next = i + width_ < legs_.size() ? legs_[i + width_] : legs_[i];
            legs_[i] = n * (next - legs_[i]);
        }
        legs_.resize(left);
    }
    maker_.make(legs_.data(), width_, coefficients_.data());
}

const Columns& ColumnSampler::sample(std::size_t begin, std::size_t end) {
    columns_.samples = end - begin;
    for (const auto& run : runs_) {
        const auto from = std::max(begin, run.first);
        const auto to = std::min(end, run.first + run.count);
        if (from >= to) {
            continue;
        }
        Task<double, double> task; // a column is a piece in one dimension
        task.coefficients =
            coefficients_.data() + run.set * static_cast<std::size_t>(maker_.degree() + 1) * width_;
        task.rowStride = width_;
        task.pieceStride = 1;
        task.pieces = width_;
        task.degree = maker_.degree();
        task.x = run.x.data() + (from - run.first);
        task.scale = run.scale.empty() ? nullptr : run.scale.data() + (from - run.first);
        task.count = to - from;
        task.out = values_.data() + (from - begin);
        task.outStride = columns_.stride;
        samplePoints(task, 1);
    }
    return columns_;
}

} // namespace splineloft::lanes
