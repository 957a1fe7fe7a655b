#include "core/spline/fast/lanes/speed_lanes.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/spline/fast/lanes/speed_lanes.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h, which compiles what follows several times.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace splineloft::lanes::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using UpToEight = hn::CappedTag<double, 8>;
using Vector = hn::Vec<UpToEight>;

/// Square roots of numbers not below zero. Those below the squares of the smallest numbers are
/// taken for zero.
HWY_INLINE Vector rootsOf(Vector x) {
#if HWY_TARGET <= HWY_AVX3
    // 8 roots take 30 cycles by the instruction for it. Goldschmidt's iteration from 14 right bits
    // takes 8; its last step makes it as good as exact.
    const UpToEight d;
    const Vector inverse{_mm512_rsqrt14_pd(x.raw)};
    auto root = hn::Mul(x, inverse);
    auto half = hn::Mul(hn::Set(d, 0.5), inverse);
    const auto rest = hn::NegMulAdd(root, half, hn::Set(d, 0.5));
    root = hn::MulAdd(root, rest, root);
    half = hn::MulAdd(half, rest, half);
    root = hn::MulAdd(hn::NegMulAdd(root, root, x), half, root);
    constexpr double smallest = 0x1p-1000;
    return hn::IfThenElseZero(hn::Ge(x, hn::Set(d, smallest)), root);
#else
    return hn::Sqrt(x);
#endif
}

/// A parabola over [-1, 1].
template <std::size_t dimension> struct Panel {
    std::array<double, dimension> a, b, c;

    HWY_INLINE Panel(const Parabola& velocity, double middle, double half) {
        for (std::size_t k = 0; k < dimension; ++k) {
            const double c0 = velocity.c[k], b0 = velocity.b[k];
            a[k] = velocity.a[k] + middle * (b0 + middle * c0);
            b[k] = half * (b0 + 2 * middle * c0);
            c[k] = half * half * c0;
        }
    }
};

/// The speeds at +x and -x.
struct Pair {
    Vector after, before;
};

template <std::size_t dimension> HWY_INLINE Pair speedsAt(const Panel<dimension>& panel, Vector x) {
    const UpToEight d;
    const auto x2 = hn::Mul(x, x);
    auto after = hn::Zero(d), before = after;
    for (std::size_t k = 0; k < dimension; ++k) {
        const auto even = hn::MulAdd(hn::Set(d, panel.c[k]), x2, hn::Set(d, panel.a[k]));
        const auto odd = hn::Mul(hn::Set(d, panel.b[k]), x);
        const auto sum = hn::Add(even, odd), difference = hn::Sub(even, odd);
        after = hn::MulAdd(sum, sum, after);
        before = hn::MulAdd(difference, difference, before);
    }
    return {rootsOf(after), rootsOf(before)};
}

template <std::size_t dimension>
HWY_INLINE void sampleIn(const Parabola& velocity, double middle, double half, const Eight& x,
                         EightPairs& speeds) {
    const UpToEight d;
    const Panel<dimension> panel(velocity, middle, half);
    for (std::size_t i = 0; i < x.size(); i += hn::Lanes(d)) {
        const auto [after, before] = speedsAt(panel, hn::LoadU(d, &x[i]));
        hn::StoreU(after, d, &speeds.after[i]);
        hn::StoreU(before, d, &speeds.before[i]);
    }
}

template <std::size_t dimension>
HWY_INLINE double integrateIn(const Parabola& velocity, const WideRule& rule,
                              std::span<const double> joints) {
    const UpToEight d;
    auto sum = hn::Zero(d);
    for (std::size_t p = 0; p + 1 < joints.size(); ++p) {
        const double half = 0.5 * (joints[p + 1] - joints[p]);
        const Panel<dimension> panel(velocity, 0.5 * (joints[p] + joints[p + 1]), half);
        auto onPanel = hn::Zero(d);
        for (std::size_t i = 0; i < rule.nodes.size(); i += hn::Lanes(d)) {
            const auto [after, before] = speedsAt(panel, hn::LoadU(d, &rule.nodes[i]));
            onPanel = hn::MulAdd(hn::LoadU(d, &rule.weights[i]), hn::Add(after, before), onPanel);
        }
        sum = hn::MulAdd(hn::Set(d, half), onPanel, sum);
    }
    return hn::GetLane(hn::SumOfLanes(d, sum));
}

void sample(const Parabola& velocity, double middle, double half, const Eight& x,
            EightPairs& speeds) {
    switch (velocity.dimension) {
    case 1: return sampleIn<1>(velocity, middle, half, x, speeds);
    case 2: return sampleIn<2>(velocity, middle, half, x, speeds);
    default: return sampleIn<3>(velocity, middle, half, x, speeds);
    }
}

double integrate(const Parabola& velocity, const WideRule& rule, std::span<const double> joints) {
    switch (velocity.dimension) {
    case 1: return integrateIn<1>(velocity, rule, joints);
    case 2: return integrateIn<2>(velocity, rule, joints);
    default: return integrateIn<3>(velocity, rule, joints);
    }
}

} // namespace
} // namespace splineloft::lanes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace splineloft::lanes {

HWY_EXPORT(sample);
HWY_EXPORT(integrate);

void sampleSpeeds(const Parabola& velocity, double middle, double half, const Eight& x,
                  EightPairs& speeds) {
    HWY_DYNAMIC_DISPATCH(sample)(velocity, middle, half, x, speeds);
}

double integrateSpeed(const Parabola& velocity, const WideRule& rule,
                      std::span<const double> joints) {
    return HWY_DYNAMIC_DISPATCH(integrate)(velocity, rule, joints);
}

} // namespace splineloft::lanes
#endif
