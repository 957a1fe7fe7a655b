#include "core/spline/fast/lanes/direct_sampler.h"

#include "core/spline/fast/lanes/dense_lanes.h"
#include "core/spline/fast/lanes/horner.h"

#include <algorithm>
#include <vector>

#ifdef __unix__
#include <unistd.h>
#endif

namespace splineloft::lanes {
namespace {

/// Bytes of the last-level cache; where the system does not say, those of a common machine.
std::size_t lastLevelCache() {
    constexpr std::size_t common = std::size_t{32} << 20;
#ifdef _SC_LEVEL3_CACHE_SIZE
    static const auto known = sysconf(_SC_LEVEL3_CACHE_SIZE);
    return known > 0 ? static_cast<std::size_t>(known) : common;
#else
    return common;
#endif
}

/// Polynomial pieces of 1 to 3 coordinates: points are written as they are computed.
template <class Number> class DirectSampler {
  public:
    DirectSampler(const Pieces& pieces, std::size_t perPiece)
        : pieces_(pieces), dimension_(static_cast<std::size_t>(pieces.dimension())),
          maker_(pieces.degree()), perPiece_(perPiece), runs_(runsOf(pieces.degree(), perPiece)),
          piece_(coefficientCount(pieces.degree()) * dimension_) {
        for (auto& run : runs_) {
            if (pieces.dimension() == 2) {
                arrangeForPairs<Number>(run.x.data(), run.count);
                arrangeForPairs<Number>(run.scale.data(), run.scale.empty() ? 0 : run.count);
            }
        }
    }

    /// All pieces, a block of coefficients at a time.
    void write(Store store, std::span<Number> out) {
        constexpr std::size_t blockPieces = 64;
        constexpr std::size_t blockNumbers = 4096; // 32 kB, within the first cache or nearly
        const auto block = std::clamp<std::size_t>(blockNumbers / piece_, 1, blockPieces);
        const auto rows = perPiece_ * dimension_;
        for (std::size_t first = 0; first < pieces_.size(); first += block) {
            const auto count = std::min(block, pieces_.size() - first);
            makeCoefficients(first, count);
            const auto to = out.subspan(first * rows);
            if (store == Store::streamed) {
                streamBlock(count, to.first(count * rows));
            } else {
                sample(0, count, 0, perPiece_, to);
            }
        }
    }

  private:
    void makeCoefficients(std::size_t first, std::size_t count) {
        const auto bezierOfPiece = static_cast<std::size_t>(pieces_.degree() + 1) * dimension_;
        const auto* bezier = pieces_.bezier().data() + first * bezierOfPiece;
        across_ = count * dimension_;
        coefficients_.resize(count * piece_);
        maker_.make(bezier, count, dimension_, coefficients_.data());
    }

    /// Samples from `begin` to before `end` of some pieces of the block, to the start of `out`,
    /// all of which may be written.
    void sample(std::size_t piece, std::size_t count, std::size_t begin, std::size_t end,
                std::span<Number> out) const {
        if (runs_.size() > 1 && count > 1) { // a run writes over what comes after it
            for (std::size_t i = 0; i < count; ++i) {
                sample(piece + i, 1, begin, end, out.subspan(i * (end - begin) * dimension_));
            }
            return;
        }
        for (const auto& run : runs_) {
            const auto from = std::max(begin, run.first);
            const auto to = std::min(end, run.first + run.count);
            if (from >= to) {
                continue;
            }
            Task<Number> task;
            task.rowStride = across_;
            task.coefficients = coefficients_.data() + piece * dimension_ +
                                run.set * static_cast<std::size_t>(pieces_.degree() + 1) * across_;
            task.pieceStride = dimension_;
            task.pieces = count;
            task.degree = pieces_.degree();
            task.x = run.x.data() + (from - run.first);
            task.scale = run.scale.empty() ? nullptr : run.scale.data() + (from - run.first);
            task.count = to - from;
            task.out = out.data() + (from - begin) * dimension_;
            task.outStride = (end - begin) * dimension_;
            task.end = out.data() + out.size();
            samplePoints(task, pieces_.dimension());
        }
    }

    /// By way of a scratch that the first cache holds: as many whole pieces as fit into it, or
    /// parts of a piece. (A part begins where a vector does, as the tables are in the order of the
    /// lanes.)
    void streamBlock(std::size_t count, std::span<Number> out) {
        constexpr std::size_t partSamples = 1024;
        const auto fitting = std::max<std::size_t>(partSamples / perPiece_, 1);
        for (std::size_t piece = 0; piece < count; piece += fitting) {
            if (perPiece_ > partSamples) {
                for (const auto& run : runs_) {
                    const auto runEnd = run.first + run.count;
                    for (auto begin = run.first; begin < runEnd; begin += partSamples) {
                        const auto end = std::min(begin + partSamples, runEnd);
                        out = streamPart(piece, 1, begin, end, out);
                    }
                }
            } else {
                out = streamPart(piece, std::min(fitting, count - piece), 0, perPiece_, out);
            }
        }
    }

    /// Returns what is left of `out`.
    std::span<Number> streamPart(std::size_t piece, std::size_t count, std::size_t begin,
                                 std::size_t end, std::span<Number> out) {
        const auto numbers = count * (end - begin) * dimension_;
        scratch_.resize(std::max(scratch_.size(), numbers + 3 * runPadding));
        sample(piece, count, begin, end, scratch_);
        streamCopy(scratch_.data(), numbers, out.data());
        return out.subspan(numbers);
    }

    const Pieces& pieces_;
    std::size_t dimension_;
    CoefficientMaker maker_;
    std::size_t perPiece_;
    std::vector<Run> runs_;
    std::size_t piece_;                ///< numbers that the coefficients of a piece take
    std::size_t across_ = 0;           ///< numbers in a row of a block's coefficients
    std::vector<double> coefficients_; ///< of a block
    std::vector<Number> scratch_;
};

} // namespace

Store storeFor(std::size_t bytes) {
    return bytes > lastLevelCache() ? Store::streamed : Store::cached;
}

void sampleDirectly(const Pieces& pieces, std::size_t perPiece, Store store,
                    std::span<double> out) {
    DirectSampler<double>(pieces, perPiece).write(store, out);
}

void sampleDirectly(const Pieces& pieces, std::size_t perPiece, Store store, std::span<float> out) {
    DirectSampler<float>(pieces, perPiece).write(store, out);
}

} // namespace splineloft::lanes
