#include "core/spline/fast/lanes/chart_lanes.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/spline/fast/lanes/chart_lanes.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h, which compiles what follows several times.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace splineloft::lanes::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using Doubles = hn::ScalableTag<double>;
using Vector = hn::Vec<Doubles>;

using UpToEight = hn::CappedTag<double, 8>;

/// `second` times (`first` times `in`).
HWY_INLINE void multiplyTwice(const EightByEight& first, const EightByEight& second,
                              const Eight& in, Eight& out) {
    const UpToEight d;
    Eight between;
    for (std::size_t row = 0; row < in.size(); row += hn::Lanes(d)) {
        auto sum = hn::Mul(hn::LoadU(d, &first[0][row]), hn::Set(d, in[0]));
        for (std::size_t column = 1; column < in.size(); ++column) {
            sum = hn::MulAdd(hn::LoadU(d, &first[column][row]), hn::Set(d, in[column]), sum);
        }
        hn::StoreU(sum, d, &between[row]);
    }
    for (std::size_t row = 0; row < in.size(); row += hn::Lanes(d)) {
        auto sum = hn::Mul(hn::LoadU(d, &second[0][row]), hn::Set(d, between[0]));
        for (std::size_t column = 1; column < in.size(); ++column) {
            sum = hn::MulAdd(hn::LoadU(d, &second[column][row]), hn::Set(d, between[column]), sum);
        }
        hn::StoreU(sum, d, &out[row]);
    }
}

void integrate(const PowerTables& tables, const Eight& sums, const Eight& differences,
               LengthSeries& series) {
    Eight even, odd;
    multiplyTwice(tables.evenCoefficients, tables.evenPowers, sums, even);
    multiplyTwice(tables.oddCoefficients, tables.oddPowers, differences, odd);
    for (std::size_t j = 0; j < even.size(); ++j) {
        const auto order = static_cast<double>(2 * j);
        series.speeds[2 * j] = even[j];
        series.speeds[2 * j + 1] = odd[j];
        series.lengths[2 * j + 1] = even[j] / (order + 1);
        series.lengths[2 * j + 2] = odd[j] / (order + 2);
    }
}

HWY_INLINE Vector bounded(Vector x) {
    const Doubles d;
    return hn::Min(hn::Max(x, hn::Set(d, -1.0)), hn::Set(d, 1.0));
}

/// x(s) by the series' start.
HWY_INLINE Vector startFor(const LengthSeries& series, Vector wanted) {
    const Doubles d;
    const auto& c = series.start;
    const auto toMiddle = hn::Sub(wanted, hn::Set(d, series.middle));
    const auto toEnd = hn::Sub(wanted, hn::Set(d, series.whole));
    auto x = hn::MulAdd(toEnd, hn::Set(d, c[5]), hn::Set(d, c[4]));
    x = hn::MulAdd(toMiddle, x, hn::Set(d, c[3]));
    x = hn::MulAdd(toMiddle, x, hn::Set(d, c[2]));
    x = hn::MulAdd(wanted, x, hn::Set(d, c[1]));
    return bounded(hn::MulAdd(wanted, x, hn::Set(d, c[0])));
}

/// What is wanted, and how far the search for it is.
struct Search {
    Vector wanted, x;
    Vector speed; // at the x before
    Vector way;   // from there
};

/// Goes one step on, whose size it gives. `isFirst`: nothing is known of an x before.
HWY_INLINE Vector advance(Search& search, Vector length, Vector speed, bool isFirst) {
    const Doubles d;
    const auto over = hn::Div(hn::Set(d, 1.0), speed);
    auto step = hn::Mul(hn::Sub(search.wanted, length), over);
    const auto size = hn::Abs(step);
    if (!isFirst) {
        // The next term of the series, with the slope of the speed from its difference: what is
        // left is of third order.
        const auto slope = hn::Div(hn::Sub(speed, search.speed), search.way);
        const auto bend =
            hn::Mul(hn::Mul(hn::Set(d, 0.5), hn::Mul(step, step)), hn::Mul(slope, over));
        const auto moved = hn::Ne(search.way, hn::Zero(d));
        step = hn::Sub(step, hn::IfThenElseZero(moved, bend));
    }
    const auto next = bounded(hn::Add(search.x, step));
    search.speed = speed;
    search.way = hn::Sub(next, search.x);
    search.x = next;
    return size;
}

/// Two vectors side by side, in even and odd powers each: as each sum waits for itself.
HWY_INLINE void invertTwo(const LengthSeries& series, Vector& a, Vector& b) {
    constexpr double enough = 3e-6; // a step of third order after which x is exact
    constexpr int mostSteps = 8;
    const Doubles d;
    const auto zero = hn::Zero(d);
    Search one{a, startFor(series, a), zero, zero};
    Search other{b, startFor(series, b), zero, zero};
    for (int round = 0; round < mostSteps; ++round) {
        const auto y0 = hn::Mul(one.x, one.x);
        const auto y1 = hn::Mul(other.x, other.x);
        constexpr auto last = LengthSeries::count;
        auto evenLength0 = hn::Set(d, series.lengths[last]), evenLength1 = evenLength0;
        auto oddLength0 = hn::Set(d, series.lengths[last - 1]), oddLength1 = oddLength0;
        auto evenSpeed0 = hn::Set(d, series.speeds[last - 2]), evenSpeed1 = evenSpeed0;
        auto oddSpeed0 = hn::Set(d, series.speeds[last - 1]), oddSpeed1 = oddSpeed0;
        for (std::size_t k = last - 2; k >= 2; k -= 2) {
            const auto evenLength = hn::Set(d, series.lengths[k]);
            const auto oddLength = hn::Set(d, series.lengths[k - 1]);
            const auto evenSpeed = hn::Set(d, series.speeds[k - 2]);
            const auto oddSpeed = hn::Set(d, series.speeds[k - 1]);
            evenLength0 = hn::MulAdd(evenLength0, y0, evenLength);
            evenLength1 = hn::MulAdd(evenLength1, y1, evenLength);
            oddLength0 = hn::MulAdd(oddLength0, y0, oddLength);
            oddLength1 = hn::MulAdd(oddLength1, y1, oddLength);
            evenSpeed0 = hn::MulAdd(evenSpeed0, y0, evenSpeed);
            evenSpeed1 = hn::MulAdd(evenSpeed1, y1, evenSpeed);
            oddSpeed0 = hn::MulAdd(oddSpeed0, y0, oddSpeed);
            oddSpeed1 = hn::MulAdd(oddSpeed1, y1, oddSpeed);
        }
        const auto atMiddle = hn::Set(d, series.lengths[0]);
        evenLength0 = hn::MulAdd(evenLength0, y0, atMiddle);
        evenLength1 = hn::MulAdd(evenLength1, y1, atMiddle);
        const bool isFirst = round == 0;
        const auto size0 = advance(one, hn::MulAdd(oddLength0, one.x, evenLength0),
                                   hn::MulAdd(oddSpeed0, one.x, evenSpeed0), isFirst);
        const auto size1 = advance(other, hn::MulAdd(oddLength1, other.x, evenLength1),
                                   hn::MulAdd(oddSpeed1, other.x, evenSpeed1), isFirst);
        const auto limit = hn::Set(d, isFirst ? enough * enough : enough);
        if (hn::AllTrue(d, hn::Lt(hn::Max(size0, size1), limit))) {
            break;
        }
    }
    a = one.x;
    b = other.x;
}

void invertMany(const LengthSeries& series, double* lengths, std::size_t count) {
    const Doubles d;
    const auto lanes = hn::Lanes(d);
    std::size_t i = 0;
    for (; i + 2 * lanes <= count; i += 2 * lanes) {
        auto a = hn::LoadU(d, lengths + i);
        auto b = hn::LoadU(d, lengths + i + lanes);
        invertTwo(series, a, b);
        hn::StoreU(a, d, lengths + i);
        hn::StoreU(b, d, lengths + i + lanes);
    }
    if (i < count) {
        const auto first = hn::FirstN(d, count - i);
        const auto second = hn::FirstN(d, count - HWY_MIN(i + lanes, count));
        auto a = hn::MaskedLoad(first, d, lengths + i);
        auto b = hn::MaskedLoad(second, d, lengths + i + lanes);
        invertTwo(series, a, b);
        hn::BlendedStore(a, first, d, lengths + i);
        hn::BlendedStore(b, second, d, lengths + i + lanes);
    }
}

} // namespace
} // namespace splineloft::lanes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace splineloft::lanes {

HWY_EXPORT(integrate);
HWY_EXPORT(invertMany);

void integrateSpeeds(const PowerTables& tables, const Eight& sums, const Eight& differences,
                     LengthSeries& series) {
    HWY_DYNAMIC_DISPATCH(integrate)(tables, sums, differences, series);
}

void invertLengths(const LengthSeries& series, double* lengths, std::size_t count) {
    HWY_DYNAMIC_DISPATCH(invertMany)(series, lengths, count);
}

} // namespace splineloft::lanes
#endif
