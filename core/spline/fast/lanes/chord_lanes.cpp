#include "core/spline/fast/lanes/chord_lanes.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/spline/fast/lanes/chord_lanes.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h, which compiles what follows several times.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace splineloft::lanes::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using Doubles = hn::CappedTag<double, 8>; // so that their masks fit a byte
static_assert(chordPadding % 8 == 0);

// Distances may be this many times as large, for the bits of the labels and for rounding.
constexpr double slack = 1 + 0x1p-44;

/// Squared distances of a place from the chords that begin at `m`. The dimension is a template
/// argument where that pays; otherwise 0.
template <std::size_t fixedDimension>
HWY_INLINE hn::Vec<Doubles> squares(const ChordRows& chords, const double* HWY_RESTRICT place,
                                    std::size_t m) {
    const Doubles d;
    const auto dimension = fixedDimension > 0 ? fixedDimension : chords.dimension;
    const double* HWY_RESTRICT const starts = chords.numbers + m;
    const double* HWY_RESTRICT const ways = starts + dimension * chords.stride;
    auto along = hn::Zero(d);
    for (std::size_t c = 0; c < dimension; ++c) {
        const auto off = hn::Sub(hn::Set(d, place[c]), hn::LoadU(d, starts + c * chords.stride));
        along = hn::MulAdd(off, hn::LoadU(d, ways + c * chords.stride), along);
    }
    along = hn::Mul(along, hn::LoadU(d, ways + dimension * chords.stride));
    along = hn::Min(hn::Max(along, hn::Zero(d)), hn::Set(d, 1.0));
    auto sum = hn::Zero(d);
    for (std::size_t c = 0; c < dimension; ++c) {
        const auto off = hn::Sub(hn::Set(d, place[c]), hn::LoadU(d, starts + c * chords.stride));
        const auto rest = hn::NegMulAdd(along, hn::LoadU(d, ways + c * chords.stride), off);
        sum = hn::MulAdd(rest, rest, sum);
    }
    return sum;
}

HWY_INLINE double rootOf(double value) {
    const hn::CappedTag<double, 1> d;
    return hn::GetLane(hn::Sqrt(hn::Set(d, value)));
}

/// One bit a chord: whether its labelled square is at most that of what is found added to its
/// radius.
HWY_INLINE std::uint64_t within(const ChordRows& chords, const double* squared, const double* radii,
                                double found) {
    const Doubles d;
    std::uint64_t result = 0;
    for (std::size_t m = 0; m < chords.stride; m += hn::Lanes(d)) {
        const auto reach =
            hn::Mul(hn::Set(d, slack), hn::Add(hn::Set(d, found), hn::LoadU(d, radii + m)));
        const auto isNear = hn::Le(hn::Load(d, squared + m), hn::Mul(reach, reach));
        std::uint8_t bits[8]; // Highway may write all
        hn::StoreMaskBits(d, isNear, bits);
        result |= std::uint64_t{bits[0]} << m;
    }
    return result;
}

template <std::size_t fixedDimension>
void choose(const ChordRows& chords, const ChordQuestion& question, ChordChoice& choice) {
    const Doubles d;
    HWY_ALIGN double squared[mostChords];
    const hn::RebindToUnsigned<Doubles> bits;
    const auto unlabelled = hn::Set(bits, ~chordMask);
    auto least = hn::Inf(d);
    auto labels = hn::Iota(bits, 0);
    for (std::size_t m = 0; m < chords.stride; m += hn::Lanes(d)) {
        const auto exact = hn::BitCast(bits, squares<fixedDimension>(chords, question.place, m));
        const auto square = hn::BitCast(d, hn::Or(hn::And(exact, unlabelled), labels));
        hn::Store(square, d, squared + m);
        least = hn::Min(least, square);
        labels = hn::Add(labels, hn::Set(bits, hn::Lanes(d)));
    }
    const auto nearest = hn::GetLane(hn::MinOfLanes(d, least));
    const double* const radii =
        chords.numbers + (ChordRows::rowsFor(chords.dimension) - 1) * chords.stride;
    Candidate label;
    hwy::CopyBytes<8>(&nearest, &label);
    choice.limit = HWY_MIN(question.limit, slack * rootOf(nearest) + radii[label & chordMask] +
                                               question.rounding + question.gap);
    const double found = choice.limit + question.rounding;
    choice.count = 0;
    for (auto left = within(chords, squared, radii, found); left != 0; left &= left - 1) {
        const auto m = static_cast<std::size_t>(hwy::Num0BitsBelowLS1Bit_Nonzero64(left));
        const double bound = rootOf(squared[m]) * (2 - slack) - radii[m] - question.rounding;
        const double atLeast = HWY_MAX(bound, 0.0);
        Candidate candidate;
        hwy::CopyBytes<8>(&atLeast, &candidate);
        choice.candidates[choice.count++] = (candidate & ~chordMask) | m;
    }
}

void chooseAmong(const ChordRows& chords, const ChordQuestion& question, ChordChoice& choice) {
    switch (chords.dimension) {
    case 2: return choose<2>(chords, question, choice);
    case 3: return choose<3>(chords, question, choice);
    default: return choose<0>(chords, question, choice);
    }
}

} // namespace
} // namespace splineloft::lanes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace splineloft::lanes {

HWY_EXPORT(chooseAmong);

ChordChoice chooseChords(const ChordRows& chords, const ChordQuestion& question) {
    ChordChoice choice;
    HWY_DYNAMIC_DISPATCH(chooseAmong)(chords, question, choice);
    return choice;
}

} // namespace splineloft::lanes
#endif
