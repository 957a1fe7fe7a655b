#include "core/spline/fast/lanes/direct_sampler.h"

#include "core/spline/fast/lanes/dense_lanes.h"
#include "core/spline/fast/lanes/horner.h"

#include <algorithm>
#include <cmath>
#include <concepts>
#include <optional>
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

/// What pieces of a kind have in common when they are sampled.
struct Kind {
    int degree = 0, dimension = 0;
    std::size_t perPiece = 0;

    bool operator==(const Kind&) const = default;
};

Kind kindOf(const Pieces& pieces, std::size_t perPiece) {
    return {pieces.degree(), pieces.dimension(), perPiece};
}

template <class Lane> std::vector<Run<Lane>> tablesFor(const Kind& kind) {
    if constexpr (std::same_as<Lane, float>) {
        return {centredRun(kind.perPiece)};
    } else {
        return runsOf(kind.degree, kind.perPiece);
    }
}

/// Polynomial pieces of 1 to 3 coordinates: points are computed in numbers of type Lane, and
/// written at once as Number.
template <class Lane, class Number> class DirectSampler {
  public:
    explicit DirectSampler(const Kind& kind)
        : kind_(kind), dimension_(static_cast<std::size_t>(kind.dimension)), maker_(kind.degree),
          runs_(tablesFor<Lane>(kind)),
          bezierOfPiece_(static_cast<std::size_t>(kind.degree + 1) * dimension_),
          piece_(isCentred ? bezierOfPiece_ + dimension_
                           : coefficientCount(kind.degree) * dimension_) {}

    const Kind& kind() const { return kind_; }

    /// All pieces, which are of this kind, a block of coefficients at a time.
    void write(const Pieces& pieces, Store store, std::span<Number> out) {
        constexpr std::size_t blockPieces = 64;
        constexpr std::size_t blockNumbers = 4096; // 32 kB, within the first cache or nearly
        const auto block = std::clamp<std::size_t>(blockNumbers / piece_, 1, blockPieces);
        const auto rows = kind_.perPiece * dimension_;
        for (std::size_t first = 0; first < pieces.size(); first += block) {
            const auto count = std::min(block, pieces.size() - first);
            const auto bezier = pieces.bezier().subspan(first * bezierOfPiece_);
            const auto to = out.subspan(first * rows, count * rows);
            makeCoefficients(bezier.data(), count);
            if (store == Store::streamed) {
                streamBlock(count, to);
            } else {
                sample({0, count, 0, kind_.perPiece}, to);
            }
        }
    }

  private:
    static constexpr bool isCentred = std::same_as<Lane, float>;

    /// Some pieces of a block, and of each of them the samples from `begin` to before `end`.
    struct Part {
        std::size_t piece, count, begin, end;
    };

    void makeCoefficients(const double* bezier, std::size_t count) {
        coefficients_.resize(count * piece_);
        for (std::size_t i = 0; i < count; ++i) {
            const double* const from = bezier + i * bezierOfPiece_;
            Lane* const to = coefficients_.data() + i * piece_;
            if constexpr (isCentred) {
                maker_.makeCentred(from, dimension_, to);
            } else {
                maker_.make(from, dimension_, to);
            }
        }
    }

    void sample(const Part& part, std::span<Number> out) const {
        const auto rows = (part.end - part.begin) * dimension_; // numbers of a piece
        for (const auto& run : runs_) {
            const auto from = std::max(part.begin, run.first);
            const auto to = std::min(part.end, run.first + run.count);
            if (from >= to) {
                continue;
            }
            Task<Lane, Number> task;
            task.rowStride = dimension_;
            task.coefficients =
                coefficients_.data() + part.piece * piece_ + run.set * bezierOfPiece_;
            task.pieceStride = piece_;
            task.pieces = part.count;
            task.degree = kind_.degree;
            task.x = run.x.data() + (from - run.first);
            task.scale = run.scale.empty() ? nullptr : run.scale.data() + (from - run.first);
            task.count = to - from;
            task.out = out.data() + (from - part.begin) * dimension_;
            task.outStride = rows;
            if constexpr (isCentred) {
                task.starts = part.begin == 0 ? task.coefficients + bezierOfPiece_ : nullptr;
            }
            samplePoints(task, kind_.dimension);
        }
    }

    /// By way of a scratch that the first cache holds: as many whole pieces as fit into it, or
    /// parts of a piece.
    void streamBlock(std::size_t count, std::span<Number> out) {
        constexpr std::size_t partSamples = 1024;
        const auto perPiece = kind_.perPiece;
        const auto fitting = std::max<std::size_t>(partSamples / perPiece, 1);
        for (std::size_t piece = 0; piece < count; piece += fitting) {
            const auto pieces = std::min(fitting, count - piece);
            for (std::size_t begin = 0; begin < perPiece; begin += partSamples) {
                const auto end = std::min(begin + partSamples, perPiece);
                out = streamPart({piece, pieces, begin, end}, out);
            }
        }
    }

    /// Returns what is left of `out`.
    std::span<Number> streamPart(const Part& part, std::span<Number> out) {
        const auto numbers = part.count * (part.end - part.begin) * dimension_;
        scratch_.resize(std::max(scratch_.size(), numbers));
        sample(part, scratch_);
        streamCopy(scratch_.data(), numbers, out.data());
        return out.subspan(numbers);
    }

    Kind kind_;
    std::size_t dimension_;
    CoefficientMaker maker_;
    std::vector<Run<Lane>> runs_;
    std::size_t bezierOfPiece_;      ///< numbers that its Bézier points take
    std::size_t piece_;              ///< numbers that its coefficients take
    std::vector<Lane> coefficients_; ///< of a block
    std::vector<Number> scratch_;
};

/// Each thread keeps the sampler of its last call, as the next is often for curves of the same
/// kind: its tables take as long as a thousand samples.
template <class Lane, class Number>
void sampleWith(const Pieces& pieces, std::size_t perPiece, Store store, std::span<Number> out) {
    constexpr std::size_t mostKept = 4096; // samples in its tables
    const auto kind = kindOf(pieces, perPiece);
    if (perPiece > mostKept) {
        return DirectSampler<Lane, Number>(kind).write(pieces, store, out);
    }
    thread_local std::optional<DirectSampler<Lane, Number>> kept;
    if (!kept || kept->kind() != kind) {
        kept.emplace(kind);
    }
    kept->write(pieces, store, out);
}

/// Whether the coefficients of all pieces are far from what a float holds.
bool areModest(const Pieces& pieces) {
    constexpr double most = 0x1p100;
    // Counted to the end, which is quicker than to look for the first.
    return std::ranges::count_if(pieces.bezier(),
                                 [](double b) { return !(std::abs(b) <= most); }) == 0;
}

} // namespace

Store storeFor(std::size_t bytes) {
    return bytes > lastLevelCache() ? Store::streamed : Store::cached;
}

void sampleDirectly(const Pieces& pieces, std::size_t perPiece, Store store,
                    std::span<double> out) {
    sampleWith<double>(pieces, perPiece, store, out);
}

void sampleDirectly(const Pieces& pieces, std::size_t perPiece, Store store, std::span<float> out) {
    if (!isScaled(pieces.degree()) && areModest(pieces)) {
        sampleWith<float>(pieces, perPiece, store, out);
    } else {
        sampleWith<double>(pieces, perPiece, store, out);
    }
}

} // namespace splineloft::lanes
