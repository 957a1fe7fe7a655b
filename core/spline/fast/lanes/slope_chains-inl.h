// Chains of rows side by side in lanes, as elimination and substitution of slopes have them.
// Included once for every set of instructions, by files that are.
#if defined(SPLINELOFT_LANES_SLOPE_CHAINS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SPLINELOFT_LANES_SLOPE_CHAINS_INL_H
#undef SPLINELOFT_LANES_SLOPE_CHAINS_INL_H
#else
#define SPLINELOFT_LANES_SLOPE_CHAINS_INL_H
#endif

#include "core/spline/fast/lanes/slope_lanes.h"

#include <hwy/highway.h>

#include <cstddef>

HWY_BEFORE_NAMESPACE();
namespace splineloft::lanes::HWY_NAMESPACE {
namespace {

// Each row waits for the division of the row before, and each slope for the one behind it. So we
// cut a block into chains and go through all of them at once, one a lane, in two vectors: while one
// waits for its division the other gets on.
//
// A chain cannot know the state that the one before will leave to it. But the state forgets: by
// induction |over| <= 1/2, so that in a row less than 1 / (2 - 1/2) of an error is left, usually
// 0.268, and in back substitution half. So each chain begins a few rows early, in any state, to
// come close; and in the end it is gone through again from the state in which it should have begun,
// until that makes no difference to the last bit. That repair needs no bound on anything: the
// result is that of a single chain, and only the time depends on how soon the rows forget.
constexpr std::size_t vectors = 2;

namespace hn = hwy::HWY_NAMESPACE;
using Doubles = hn::CappedTag<double, mostSlopeChains / vectors>;
using Indices = hn::RebindToSigned<Doubles>;
using Single = hn::CappedTag<double, 1>;

HWY_INLINE std::size_t chains() {
    return vectors * hn::Lanes(Doubles());
}

} // namespace
} // namespace splineloft::lanes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
