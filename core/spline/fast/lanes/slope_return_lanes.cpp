#include "core/spline/fast/lanes/slope_lanes.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/spline/fast/lanes/slope_return_lanes.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h, which compiles what follows several times.
#include <hwy/highway.h>

#include "core/spline/fast/lanes/slope_chains-inl.h"

#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace splineloft::lanes::HWY_NAMESPACE {
namespace {

// Every chain begins so many rows behind its end, which it thereby foresees.
constexpr std::size_t rowsAhead = 64;

/// m[i] from m[i+1], in all chains of a vector or in one.
template <class D>
HWY_INLINE hn::Vec<D> slopeBefore(D d, const SlopeBlock& block, std::size_t at, hn::Vec<D> next) {
    return hn::NegMulAdd(hn::LoadU(d, block.over + at), next, hn::LoadU(d, block.reduced + at));
}

/// Every chain begins a few rows behind its end, in the next chain's column; the last one knows.
void foreseeNexts(const SlopeBlock& block, double next, double* nexts) {
    const Doubles d;
    hn::Vec<Doubles> slopes[vectors];
    for (auto& slope : slopes) {
        slope = hn::Zero(d);
    }
    for (std::size_t row = HWY_MIN(rowsAhead, block.length); row-- > 0;) {
        for (std::size_t v = 0; v < vectors; ++v) {
            const auto at = row * chains() + v * hn::Lanes(d) + 1;
            slopes[v] = slopeBefore(d, block, at, slopes[v]);
        }
    }
    for (std::size_t v = 0; v < vectors; ++v) {
        hn::StoreU(slopes[v], d, nexts + v * hn::Lanes(d));
    }
    nexts[chains() - 1] = next;
}

/// Whatever chains have foreseen wrongly they go through again, until that changes nothing.
void repairSlopes(const SlopeBlock& block, const double* nexts, double* slopes) {
    const Single d;
    for (std::size_t chain = chains() - 1; chain-- > 0;) {
        double* const own = slopes + chain * block.length;
        double slope = own[block.length];
        for (std::size_t row = slope == nexts[chain] ? 0 : block.length; row-- > 0;) {
            const auto at = row * chains() + chain;
            slope = hn::GetLane(slopeBefore(d, block, at, hn::Set(d, slope)));
            if (slope == own[row]) {
                break;
            }
            own[row] = slope;
        }
    }
}

// Slopes come in columns, of which so many rows are turned into chains at once: they stay in the
// first-level cache, and the last of them have left the processor's queue of stores.
constexpr std::size_t tileRows = 64;

/// Writes column after column, each `stride` behind the one before.
HWY_INLINE void writeColumns(const double* columns, std::size_t rows, double* out,
                             std::size_t stride) {
    const Doubles d;
    const Indices indices;
    const auto lanes = hn::Lanes(d);
    const auto steps =
        hn::Mul(hn::Iota(indices, 0), hn::Set(indices, static_cast<std::int64_t>(chains())));
    std::size_t row = 0;
    for (; row + lanes <= rows; row += lanes) {
        for (std::size_t chain = 0; chain < chains(); ++chain) {
            const auto column = hn::GatherIndex(d, columns + row * chains() + chain, steps);
            hn::StoreU(column, d, out + chain * stride + row);
        }
    }
    for (; row < rows; ++row) {
        for (std::size_t chain = 0; chain < chains(); ++chain) {
            out[chain * stride + row] = columns[row * chains() + chain];
        }
    }
}

void substituteBlock(const SlopeBlock& block, double next, double* HWY_RESTRICT slopes) {
    const Doubles d;
    double nexts[mostSlopeChains];
    foreseeNexts(block, next, nexts);
    hn::Vec<Doubles> slope[vectors];
    for (std::size_t v = 0; v < vectors; ++v) {
        slope[v] = hn::LoadU(d, nexts + v * hn::Lanes(d));
    }
    HWY_ALIGN double tile[tileRows * mostSlopeChains];
    for (std::size_t end = block.length; end > 0;) {
        const std::size_t rows = HWY_MIN(tileRows, end);
        end -= rows;
        for (std::size_t row = rows; row-- > 0;) {
            for (std::size_t v = 0; v < vectors; ++v) {
                const auto column = v * hn::Lanes(d);
                slope[v] = slopeBefore(d, block, (end + row) * chains() + column, slope[v]);
                hn::Store(slope[v], d, tile + row * chains() + column);
            }
        }
        writeColumns(tile, rows, slopes + end, block.length);
    }
    repairSlopes(block, nexts, slopes);
}

double foresee(const SlopeBlock& block) {
    const Single d;
    auto slope = hn::Zero(d);
    for (std::size_t row = HWY_MIN(rowsAhead, block.length); row-- > 0;) {
        slope = slopeBefore(d, block, row * chains(), slope);
    }
    return hn::GetLane(slope);
}

} // namespace
} // namespace splineloft::lanes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace splineloft::lanes {

HWY_EXPORT(foresee);
HWY_EXPORT(substituteBlock);

double foreseenSlope(const SlopeBlock& block) {
    return HWY_DYNAMIC_DISPATCH(foresee)(block);
}

void substitute(const SlopeBlock& block, double next, double* slopes) {
    HWY_DYNAMIC_DISPATCH(substituteBlock)(block, next, slopes);
}

} // namespace splineloft::lanes
#endif
