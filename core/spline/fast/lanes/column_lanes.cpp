#include "core/spline/fast/lanes/column_lanes.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/spline/fast/lanes/column_lanes.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h, which compiles what follows several times.
#include <hwy/highway.h>

#include <cmath>
#include <cstring>

HWY_BEFORE_NAMESPACE();
namespace splineloft::lanes::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using Doubles = hn::ScalableTag<double>;

void projectPlaces(const Columns& p) {
    const Doubles d;
    const double* const weight = p[p.dimension];
    for (std::size_t i = 0; i < p.samples; i += hn::Lanes(d)) {
        const auto over = hn::Div(hn::Set(d, 1.0), hn::LoadU(d, weight + i));
        for (int c = 0; c < p.dimension; ++c) {
            hn::StoreU(hn::Mul(over, hn::LoadU(d, p[c] + i)), d, p[c] + i);
        }
    }
}

// From A = w P follow A' = w' P + w P' and A'' = w'' P + 2 w' P' + w P''.
void projectAll(const Columns& p, const Columns& f, const Columns& s) {
    const Doubles d;
    for (std::size_t i = 0; i < p.samples; i += hn::Lanes(d)) {
        const auto over = hn::Div(hn::Set(d, 1.0), hn::LoadU(d, p[p.dimension] + i));
        const auto w1 = hn::LoadU(d, f[p.dimension] + i);
        const auto w2 = hn::LoadU(d, s[p.dimension] + i);
        for (int c = 0; c < p.dimension; ++c) {
            const auto place = hn::Mul(over, hn::LoadU(d, p[c] + i));
            const auto first = hn::Mul(over, hn::NegMulAdd(w1, place, hn::LoadU(d, f[c] + i)));
            const auto rest = hn::NegMulAdd(w2, place, hn::LoadU(d, s[c] + i));
            const auto second = hn::Mul(over, hn::NegMulAdd(hn::Add(w1, w1), first, rest));
            hn::StoreU(place, d, p[c] + i);
            hn::StoreU(first, d, f[c] + i);
            hn::StoreU(second, d, s[c] + i);
        }
    }
}

/// The power of two that brings the fastest sample's largest component to about 1, so that squares
/// neither overflow nor underflow; 1 where nothing moves.
double speedScale(const Columns& f) {
    const Doubles d;
    double largest = 0;
    for (int c = 0; c < f.dimension; ++c) {
        auto most = hn::Zero(d);
        std::size_t i = 0;
        for (; i + hn::Lanes(d) <= f.samples; i += hn::Lanes(d)) {
            most = hn::Max(most, hn::Abs(hn::LoadU(d, f[c] + i)));
        }
        largest = HWY_MAX(largest, hn::GetLane(hn::MaxOfLanes(d, most)));
        for (; i < f.samples; ++i) {
            largest = HWY_MAX(largest, std::abs(f[c][i]));
        }
    }
    constexpr int safe = 1000; // 2^safe is finite
    return largest > 0 ? std::ldexp(1.0, HWY_MIN(HWY_MAX(-std::ilogb(largest), -safe), safe)) : 1;
}

/// Stores the curvature k / scale, and 0 wherever that is none.
template <class V>
HWY_INLINE void storeCurvature(V curvature, V speedSquared, double scale, double* out) {
    const Doubles d;
    constexpr double leastSquare = 1e-300; // of the scaled speed; its inverse is finite
    constexpr double mostFinite = 1.7976931348623157e308;
    const auto scaled = hn::Mul(curvature, hn::Set(d, scale));
    const auto moves = hn::Ge(speedSquared, hn::Set(d, leastSquare));
    const auto finite = hn::Le(hn::Abs(scaled), hn::Set(d, mostFinite));
    hn::StoreU(hn::IfThenElseZero(hn::And(moves, finite), scaled), d, out);
}

void planeCurvatures(const Columns& f, const Columns& s, double scale, double* out) {
    const Doubles d;
    const auto by = hn::Set(d, scale);
    for (std::size_t i = 0; i < f.samples; i += hn::Lanes(d)) {
        const auto x1 = hn::Mul(by, hn::LoadU(d, f[0] + i));
        const auto y1 = hn::Mul(by, hn::LoadU(d, f[1] + i));
        const auto x2 = hn::Mul(by, hn::LoadU(d, s[0] + i));
        const auto y2 = hn::Mul(by, hn::LoadU(d, s[1] + i));
        const auto square = hn::MulAdd(x1, x1, hn::Mul(y1, y1));
        const auto cross = hn::Sub(hn::Mul(x1, y2), hn::Mul(y1, x2));
        const auto over = hn::Div(hn::Set(d, 1.0), hn::Sqrt(square));
        storeCurvature(hn::Mul(hn::Mul(hn::Mul(cross, over), over), over), square, scale, out + i);
    }
}

/// The part of P'' across P', by the speed squared.
void spaceCurvatures(const Columns& f, const Columns& s, double scale, double* out) {
    const Doubles d;
    const auto by = hn::Set(d, scale);
    for (std::size_t i = 0; i < f.samples; i += hn::Lanes(d)) {
        auto square = hn::Zero(d);
        auto along = hn::Zero(d);
        for (int c = 0; c < f.dimension; ++c) {
            const auto first = hn::Mul(by, hn::LoadU(d, f[c] + i));
            square = hn::MulAdd(first, first, square);
            along = hn::MulAdd(first, hn::Mul(by, hn::LoadU(d, s[c] + i)), along);
        }
        const auto over = hn::Div(hn::Set(d, 1.0), square);
        auto across = hn::Zero(d);
        for (int c = 0; c < f.dimension; ++c) {
            const auto first = hn::Mul(by, hn::LoadU(d, f[c] + i));
            const auto part =
                hn::NegMulAdd(hn::Mul(along, over), first, hn::Mul(by, hn::LoadU(d, s[c] + i)));
            across = hn::MulAdd(part, part, across);
        }
        storeCurvature(hn::Mul(hn::Sqrt(across), over), square, scale, out + i);
    }
}

void curvatures(const Columns& f, const Columns& s, double* out) {
    const double scale = speedScale(f);
    if (f.dimension == 1) {
        std::memset(out, 0, f.samples * sizeof(double)); // a line does not bend
    } else if (f.dimension == 2) {
        planeCurvatures(f, s, scale, out);
    } else {
        spaceCurvatures(f, s, scale, out);
    }
}

HWY_INLINE hn::Vec<Doubles> numbers(Doubles d, const double* from, double) {
    return hn::LoadU(d, from);
}
HWY_INLINE hn::Vec<hn::Rebind<float, Doubles>> numbers(Doubles d, const double* from, float) {
    return hn::DemoteTo(hn::Rebind<float, Doubles>(), hn::LoadU(d, from));
}

/// Two and three columns by shuffling whole vectors, other numbers and what is left one by one.
template <class Number> void weaveColumns(const Columns& p, Number* HWY_RESTRICT out) {
    const Doubles d;
    const hn::Rebind<Number, Doubles> to;
    const auto lanes = hn::Lanes(d);
    std::size_t i = 0;
    for (; p.dimension == 2 && i + lanes <= p.samples; i += lanes) {
        hn::StoreInterleaved2(numbers(d, p[0] + i, Number{}), numbers(d, p[1] + i, Number{}), to,
                              out + 2 * i);
    }
    for (; p.dimension == 3 && i + lanes <= p.samples; i += lanes) {
        hn::StoreInterleaved3(numbers(d, p[0] + i, Number{}), numbers(d, p[1] + i, Number{}),
                              numbers(d, p[2] + i, Number{}), to, out + 3 * i);
    }
    Number* next = out + i * static_cast<std::size_t>(p.dimension);
    for (; i < p.samples; ++i) {
        for (int c = 0; c < p.dimension; ++c) {
            *next++ = static_cast<Number>(p[c][i]);
        }
    }
}

void weaveDouble(const Columns& columns, double* out) {
    weaveColumns(columns, out);
}
void weaveFloat(const Columns& columns, float* out) {
    weaveColumns(columns, out);
}

} // namespace
} // namespace splineloft::lanes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace splineloft::lanes {

HWY_EXPORT(projectPlaces);
HWY_EXPORT(projectAll);
HWY_EXPORT(curvatures);
HWY_EXPORT(weaveDouble);
HWY_EXPORT(weaveFloat);

void projectPositions(const Columns& positions) {
    HWY_DYNAMIC_DISPATCH(projectPlaces)(positions);
}

void projectJets(const Columns& positions, const Columns& firsts, const Columns& seconds) {
    HWY_DYNAMIC_DISPATCH(projectAll)(positions, firsts, seconds);
}

void curvaturesOf(const Columns& firsts, const Columns& seconds, double* out) {
    HWY_DYNAMIC_DISPATCH(curvatures)(firsts, seconds, out);
}

void weave(const Columns& columns, double* out) {
    HWY_DYNAMIC_DISPATCH(weaveDouble)(columns, out);
}

void weave(const Columns& columns, float* out) {
    HWY_DYNAMIC_DISPATCH(weaveFloat)(columns, out);
}

} // namespace splineloft::lanes
#endif
