#include "core/spline/fast/lanes/slope_lanes.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/spline/fast/lanes/slope_lanes.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h, which compiles what follows several times.
#include <hwy/highway.h>

#include "core/spline/fast/lanes/slope_chains-inl.h"

#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace splineloft::lanes::HWY_NAMESPACE {
namespace {

constexpr std::size_t warmUp = 36;
static_assert(leastChain >= warmUp);

std::size_t chainsOfThisSet() {
    return chains();
}

/// Where elimination is in one chain or several.
template <class D> struct Front {
    using V = hn::Vec<D>;
    V x, y;     // of the next row
    V interval; // before it
    V chord, over, reduced;
};

/// The second derivatives of both pieces at a point agree: with intervals h before and k behind it
/// and three times the slopes of their chords, s and t,
///     k m[i-1] + 2 (h + k) m[i] + h m[i+1] = k s + h t.
/// The row's division and that of its chord are one: 1 / k is pivot / (k pivot).
template <class D> HWY_INLINE void step(D d, Front<D>& front, hn::Vec<D> x, hn::Vec<D> y) {
    const auto h = front.interval;
    const auto k = hn::Sub(x, front.x);
    const auto rise = hn::Sub(y, front.y);
    const auto sum = hn::Add(h, k);
    const auto diagonal = hn::Add(sum, sum);
    const auto pivot = hn::NegMulAdd(k, front.over, diagonal);
    const auto whole = hn::NegMulAdd(hn::Mul(k, k), front.over, hn::Mul(k, diagonal));
    const auto inverse = hn::Div(hn::Set(d, 1.0), whole); // of k pivot
    const auto chord = hn::Mul(hn::Mul(hn::Set(d, 3.0), rise), hn::Mul(inverse, pivot));
    const auto right = hn::MulAdd(k, hn::Sub(front.chord, front.reduced), hn::Mul(h, chord));
    front.over = hn::Mul(hn::Mul(h, k), inverse);
    front.reduced = hn::Mul(hn::Mul(inverse, k), right);
    front.x = x;
    front.y = y;
    front.interval = k;
    front.chord = chord;
}

Front<Single> frontAt(const double* x, const double* y, std::size_t i, const SlopeState& before) {
    const Single d;
    return {hn::Set(d, x[i]),         hn::Set(d, y[i]),        hn::Set(d, x[i] - x[i - 1]),
            hn::Set(d, before.chord), hn::Set(d, before.over), hn::Set(d, before.reduced)};
}

SlopeState stateOf(const Front<Single>& front) {
    return {hn::GetLane(front.chord), hn::GetLane(front.over), hn::GetLane(front.reduced)};
}

HWY_INLINE void advance(const double* x, const double* y, std::size_t i, Front<Single>& front) {
    const Single d;
    step(d, front, hn::Set(d, x[i + 1]), hn::Set(d, y[i + 1]));
}

void eliminateRows(const double* x, const double* y, std::size_t first, std::size_t count,
                   const SlopeState& before, double* over, double* reduced, SlopeState& after) {
    auto front = frontAt(x, y, first, before);
    for (std::size_t i = 0; i < count; ++i) {
        advance(x, y, first + i, front);
        over[i] = hn::GetLane(front.over);
        reduced[i] = hn::GetLane(front.reduced);
    }
    after = stateOf(front);
}

/// The states of all chains, beside each other.
struct States {
    double chord[mostSlopeChains], over[mostSlopeChains], reduced[mostSlopeChains];

    SlopeState of(std::size_t chain) const { return {chord[chain], over[chain], reduced[chain]}; }
    void set(std::size_t chain, const SlopeState& state) {
        chord[chain] = state.chord;
        over[chain] = state.over;
        reduced[chain] = state.reduced;
    }
};

/// The fronts of all chains of a block. Values of points are gathered from all over it.
struct Fronts {
    Front<Doubles> of[vectors];

    HWY_INLINE void enter(const States& states) {
        const Doubles d;
        for (std::size_t v = 0; v < vectors; ++v) {
            const auto c = v * hn::Lanes(d);
            of[v].chord = hn::LoadU(d, states.chord + c);
            of[v].over = hn::LoadU(d, states.over + c);
            of[v].reduced = hn::LoadU(d, states.reduced + c);
        }
    }
    HWY_INLINE void leave(States& states) const {
        const Doubles d;
        for (std::size_t v = 0; v < vectors; ++v) {
            const auto c = v * hn::Lanes(d);
            hn::StoreU(of[v].chord, d, states.chord + c);
            hn::StoreU(of[v].over, d, states.over + c);
            hn::StoreU(of[v].reduced, d, states.reduced + c);
        }
    }
};

/// Points, one of each chain.
struct Cursor {
    const double *x, *y;              // of the first chain
    hn::Vec<Indices> starts[vectors]; // of the chains

    Cursor(const double* firstX, const double* firstY, std::size_t length, std::size_t least)
        : x(firstX), y(firstY) {
        const Indices d;
        const auto stride = hn::Set(d, static_cast<std::int64_t>(length));
        for (std::size_t v = 0; v < vectors; ++v) {
            const auto chain = hn::Iota(d, static_cast<std::int64_t>(v * hn::Lanes(d)));
            starts[v] =
                hn::Max(hn::Mul(chain, stride), hn::Set(d, static_cast<std::int64_t>(least)));
        }
    }
    /// At row 0.
    HWY_INLINE void place(Fronts& fronts) const {
        const Doubles d;
        for (std::size_t v = 0; v < vectors; ++v) {
            auto& front = fronts.of[v];
            front.x = hn::GatherIndex(d, x, starts[v]);
            front.y = hn::GatherIndex(d, y, starts[v]);
            front.interval = hn::Sub(front.x, hn::GatherIndex(d, x - 1, starts[v]));
        }
    }
    HWY_INLINE void advance(Fronts& fronts, std::size_t v, std::size_t row) const {
        const Doubles d;
        step(d, fronts.of[v], hn::GatherIndex(d, x + row + 1, starts[v]),
             hn::GatherIndex(d, y + row + 1, starts[v]));
    }
};

/// Which states the chains begin in: all but the first have gone through a few rows before.
States warmedUp(const double* x, const double* y, const SlopeBlock& block) {
    States states{};
    Fronts fronts;
    fronts.enter(states);
    // The first chain, which has nothing before it, goes through its own rows for nothing.
    const std::ptrdiff_t before =
        static_cast<std::ptrdiff_t>(block.first) - static_cast<std::ptrdiff_t>(warmUp);
    const Cursor cursor(x + before, y + before, block.length, warmUp);
    cursor.place(fronts);
    for (std::size_t row = 0; row < warmUp; ++row) {
        for (std::size_t v = 0; v < vectors; ++v) {
            cursor.advance(fronts, v, row);
        }
    }
    fronts.leave(states);
    return states;
}

/// Goes through a chain again, until that changes nothing. Twice: `over` of a row is all that the
/// chord behind the next one depends on, which is not kept.
void repairChain(const double* x, const double* y, const SlopeBlock& block, std::size_t chain,
                 const SlopeState& before, SlopeState& end) {
    const std::size_t first = block.first + chain * block.length;
    auto front = frontAt(x, y, first, before);
    int same = 0;
    for (std::size_t i = 0; i < block.length; ++i) {
        advance(x, y, first + i, front);
        const auto state = stateOf(front);
        double& over = block.over[i * chains() + chain];
        double& reduced = block.reduced[i * chains() + chain];
        same = over == state.over && reduced == state.reduced ? same + 1 : 0;
        if (same == 2) {
            return;
        }
        over = state.over;
        reduced = state.reduced;
    }
    end = stateOf(front);
}

void eliminateBlock(const double* x, const double* y, const SlopeBlock& block,
                    const SlopeState& before, const Upcoming& upcoming, SlopeState& after) {
    const Doubles d;
    // In the second-level cache, as this block fills the first.
    constexpr int secondLevel = 2;
    const Upcoming soon = upcoming.x != nullptr ? upcoming : Upcoming{block.over, block.reduced};
    States begun = warmedUp(x, y, block);
    begun.set(0, before);
    Fronts fronts;
    fronts.enter(begun);
    const Cursor cursor(x + block.first, y + block.first, block.length, 0);
    cursor.place(fronts);
    double* HWY_RESTRICT over = block.over;
    double* HWY_RESTRICT reduced = block.reduced;
    for (std::size_t row = 0; row < block.length; ++row) {
        for (std::size_t v = 0; v < vectors; ++v) {
            cursor.advance(fronts, v, row);
            hn::StoreU(fronts.of[v].over, d, over);
            hn::StoreU(fronts.of[v].reduced, d, reduced);
            const auto at = row * chains() + v * hn::Lanes(d);
            __builtin_prefetch(soon.x + at, 0, secondLevel);
            __builtin_prefetch(soon.y + at, 0, secondLevel);
            over += hn::Lanes(d);
            reduced += hn::Lanes(d);
        }
    }
    States ended;
    fronts.leave(ended);
    for (std::size_t chain = 1; chain < chains(); ++chain) {
        const auto left = ended.of(chain - 1);
        if (!(left == begun.of(chain))) {
            auto end = ended.of(chain);
            repairChain(x, y, block, chain, left, end);
            ended.set(chain, end);
        }
    }
    after = ended.of(chains() - 1);
}

} // namespace
} // namespace splineloft::lanes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace splineloft::lanes {

HWY_EXPORT(chainsOfThisSet);
HWY_EXPORT(eliminateBlock);
HWY_EXPORT(eliminateRows);

std::size_t slopeChains() {
    return HWY_DYNAMIC_DISPATCH(chainsOfThisSet)();
}

SlopeState eliminate(const double* x, const double* y, const SlopeBlock& block,
                     const SlopeState& before, const Upcoming& upcoming) {
    SlopeState after;
    HWY_DYNAMIC_DISPATCH(eliminateBlock)(x, y, block, before, upcoming, after);
    return after;
}

SlopeState eliminateOneByOne(const double* x, const double* y, std::size_t first, std::size_t count,
                             const SlopeState& before, double* over, double* reduced) {
    SlopeState after;
    HWY_DYNAMIC_DISPATCH(eliminateRows)(x, y, first, count, before, over, reduced, after);
    return after;
}

} // namespace splineloft::lanes
#endif
