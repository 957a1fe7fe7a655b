#include "core/spline/fast/lanes/chart_lanes.h"

#include <algorithm>
#include <tuple>

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

/// `matrix` times `in`, in two sums: as each waits for itself.
HWY_INLINE void multiply(const EightByEight& matrix, const Eight& in, Eight& out) {
    const UpToEight d;
    for (std::size_t row = 0; row < in.size(); row += hn::Lanes(d)) {
        auto sum = hn::Mul(hn::LoadU(d, &matrix[0][row]), hn::Set(d, in[0]));
        auto other = hn::Mul(hn::LoadU(d, &matrix[1][row]), hn::Set(d, in[1]));
        for (std::size_t column = 2; column < in.size(); column += 2) {
            sum = hn::MulAdd(hn::LoadU(d, &matrix[column][row]), hn::Set(d, in[column]), sum);
            other = hn::MulAdd(hn::LoadU(d, &matrix[column + 1][row]), hn::Set(d, in[column + 1]),
                               other);
        }
        hn::StoreU(hn::Add(sum, other), d, &out[row]);
    }
}

void weigh(const EightByEight& even, const EightByEight& odd, const EightPairs& pairs,
           Eight& ofSums, Eight& ofDifferences) {
    const UpToEight d;
    Eight sums, differences;
    for (std::size_t i = 0; i < sums.size(); i += hn::Lanes(d)) {
        const auto after = hn::LoadU(d, &pairs.after[i]);
        const auto before = hn::LoadU(d, &pairs.before[i]);
        hn::StoreU(hn::Add(after, before), d, &sums[i]);
        hn::StoreU(hn::Sub(after, before), d, &differences[i]);
    }
    multiply(even, sums, ofSums);
    multiply(odd, differences, ofDifferences);
}

// Integrals of x^0, x^2 to x^14, and of x^1, x^3 to x^15, from 0 to 1.
constexpr Eight ofEven = {1, 1.0 / 3, 1.0 / 5, 1.0 / 7, 1.0 / 9, 1.0 / 11, 1.0 / 13, 1.0 / 15};
constexpr Eight ofOdd = {1.0 / 2,  1.0 / 4,  1.0 / 6,  1.0 / 8,
                         1.0 / 10, 1.0 / 12, 1.0 / 14, 1.0 / 16};

EndSpeeds integrate(const EightByEight& evenPowers, const EightByEight& oddPowers,
                    const Eight& even, const Eight& odd, LengthSeries& series) {
    multiply(evenPowers, even, series.evenSpeed);
    multiply(oddPowers, odd, series.oddSpeed);
    const UpToEight d;
    auto evenSpeeds = hn::Zero(d), oddSpeeds = evenSpeeds;
    auto oddLengths = evenSpeeds, evenLengths = evenSpeeds;
    for (std::size_t i = 0; i < even.size(); i += hn::Lanes(d)) {
        const auto evenSpeed = hn::LoadU(d, &series.evenSpeed[i]);
        const auto oddSpeed = hn::LoadU(d, &series.oddSpeed[i]);
        const auto oddLength = hn::Mul(evenSpeed, hn::LoadU(d, &ofEven[i]));
        const auto evenLength = hn::Mul(oddSpeed, hn::LoadU(d, &ofOdd[i]));
        hn::StoreU(oddLength, d, &series.oddLength[i]);
        hn::StoreU(evenLength, d, &series.evenLength[i]);
        evenSpeeds = hn::Add(evenSpeeds, evenSpeed);
        oddSpeeds = hn::Add(oddSpeeds, oddSpeed);
        oddLengths = hn::Add(oddLengths, oddLength);
        evenLengths = hn::Add(evenLengths, evenLength);
    }
    const auto total = [&](auto v) HWY_ATTR { return hn::GetLane(hn::SumOfLanes(d, v)); };
    const double evenSpeed = total(evenSpeeds), oddSpeed = total(oddSpeeds);
    const double oddLength = total(oddLengths), evenLength = total(evenLengths);
    series.middle = oddLength - evenLength;
    series.whole = 2 * oddLength;
    return {evenSpeed - oddSpeed, evenSpeed + oddSpeed};
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
    Vector over; // 1 / speed at the x before
};

/// Goes one step of Newton's method on, whose size it gives. `isClose`: the speed is about what it
/// was at the x before.
HWY_INLINE Vector advance(Search& search, Vector length, Vector speed, bool isClose) {
    const Doubles d;
    // A division takes as long as all the rest.
    search.over = isClose ? hn::Mul(search.over, hn::NegMulAdd(speed, search.over, hn::Set(d, 2.0)))
                          : hn::Div(hn::Set(d, 1.0), speed);
    const auto step = hn::Mul(hn::Sub(search.wanted, length), search.over);
    search.x = bounded(hn::Add(search.x, step));
    return hn::Abs(step);
}

/// Some vectors side by side, in even and odd powers each: as each sum waits for itself.
template <std::size_t n> HWY_INLINE void invertVectors(const LengthSeries& series, Vector* v) {
    // Where a chart is good, its speed changes by less than itself from its middle to its ends. So
    // a step leaves less than its square, and the speed after it is about the same.
    constexpr double enough = 1e-8, close = 1e-3;
    constexpr int mostSteps = 8;
    const Doubles d;
    Search searches[n];
    for (std::size_t i = 0; i < n; ++i) {
        searches[i] = {v[i], startFor(series, v[i]), hn::Zero(d)};
    }
    bool isClose = false;
    for (int round = 0; round < mostSteps; ++round) {
        constexpr auto last = std::tuple_size_v<Eight> - 1;
        Vector y[n], evenLength[n], oddLength[n], evenSpeed[n], oddSpeed[n];
        for (std::size_t i = 0; i < n; ++i) {
            y[i] = hn::Mul(searches[i].x, searches[i].x);
            evenLength[i] = hn::Set(d, series.evenLength[last]);
            oddLength[i] = hn::Set(d, series.oddLength[last]);
            evenSpeed[i] = hn::Set(d, series.evenSpeed[last]);
            oddSpeed[i] = hn::Set(d, series.oddSpeed[last]);
        }
        for (std::size_t k = last; k-- > 0;) {
            for (std::size_t i = 0; i < n; ++i) {
                evenLength[i] = hn::MulAdd(evenLength[i], y[i], hn::Set(d, series.evenLength[k]));
                oddLength[i] = hn::MulAdd(oddLength[i], y[i], hn::Set(d, series.oddLength[k]));
                evenSpeed[i] = hn::MulAdd(evenSpeed[i], y[i], hn::Set(d, series.evenSpeed[k]));
                oddSpeed[i] = hn::MulAdd(oddSpeed[i], y[i], hn::Set(d, series.oddSpeed[k]));
            }
        }
        auto largest = hn::Zero(d);
        for (std::size_t i = 0; i < n; ++i) {
            const auto x = searches[i].x;
            const auto fromStart = hn::MulAdd(evenLength[i], y[i], hn::Set(d, series.middle));
            const auto length = hn::MulAdd(oddLength[i], x, fromStart);
            const auto speed = hn::MulAdd(oddSpeed[i], x, evenSpeed[i]);
            largest = hn::Max(largest, advance(searches[i], length, speed, isClose));
        }
        if (hn::AllTrue(d, hn::Lt(largest, hn::Set(d, enough)))) {
            break;
        }
        isClose = hn::AllTrue(d, hn::Lt(largest, hn::Set(d, close)));
    }
    for (std::size_t i = 0; i < n; ++i) {
        v[i] = searches[i].x;
    }
}

/// n vectors of lengths.
template <std::size_t n>
HWY_INLINE void invertSome(const LengthSeries& series, const PanelPlace& place, double* lengths) {
    const Doubles d;
    const auto lanes = hn::Lanes(d);
    const auto before = hn::Set(d, place.lengthBefore);
    const auto toSeries = hn::Set(d, place.toSeries);
    Vector v[n];
    for (std::size_t i = 0; i < n; ++i) {
        v[i] = hn::Mul(hn::Sub(hn::LoadU(d, lengths + i * lanes), before), toSeries);
    }
    invertVectors<n>(series, v);
    const auto start = hn::Set(d, place.start), end = hn::Set(d, place.end);
    const auto middle = hn::Set(d, 0.5 * (place.start + place.end));
    const auto half = hn::Set(d, 0.5 * (place.end - place.start));
    for (std::size_t i = 0; i < n; ++i) {
        const auto u = hn::MulAdd(half, v[i], middle);
        hn::StoreU(hn::Min(hn::Max(u, start), end), d, lengths + i * lanes);
    }
}

void invertMany(const LengthSeries& series, const PanelPlace& place, double* lengths,
                std::size_t count) {
    // As many abreast as the registers hold, and no more than there are.
    constexpr std::size_t most = hn::MaxLanes(Doubles()) >= 8 ? 4 : 2;
    const auto lanes = hn::Lanes(Doubles());
    double filledUp[most * hn::MaxLanes(Doubles())];
    while (count > 0) {
        const auto abreast = HWY_MIN(most, (count + lanes - 1) / lanes);
        const auto taken = HWY_MIN(count, abreast * lanes);
        auto* const here = taken < abreast * lanes ? filledUp : lengths;
        if (here != lengths) {
            std::fill(std::copy_n(lengths, taken, here), here + abreast * lanes,
                      place.lengthBefore);
        }
        switch (abreast) {
        case 1: invertSome<1>(series, place, here); break;
        case 2: invertSome<2>(series, place, here); break;
        case 3: invertSome<HWY_MIN(most, 3)>(series, place, here); break;
        default: invertSome<most>(series, place, here);
        }
        if (here != lengths) {
            std::copy_n(here, taken, lengths);
        }
        lengths += taken;
        count -= taken;
    }
}

} // namespace
} // namespace splineloft::lanes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace splineloft::lanes {

HWY_EXPORT(weigh);
HWY_EXPORT(integrate);
HWY_EXPORT(invertMany);

void weighPairs(const EightByEight& even, const EightByEight& odd, const EightPairs& pairs,
                Eight& ofSums, Eight& ofDifferences) {
    HWY_DYNAMIC_DISPATCH(weigh)(even, odd, pairs, ofSums, ofDifferences);
}

EndSpeeds integrateSeries(const EightByEight& evenPowers, const EightByEight& oddPowers,
                          const Eight& even, const Eight& odd, LengthSeries& series) {
    return HWY_DYNAMIC_DISPATCH(integrate)(evenPowers, oddPowers, even, odd, series);
}

void invertLengths(const LengthSeries& series, const PanelPlace& place, double* lengths,
                   std::size_t count) {
    HWY_DYNAMIC_DISPATCH(invertMany)(series, place, lengths, count);
}

} // namespace splineloft::lanes
#endif
