#include "core/spline/fast/lanes/plane_jet_lanes.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/spline/fast/lanes/plane_jet_lanes.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h, which compiles what follows several times.
#include <hwy/highway.h>

#include "core/spline/fast/lanes/weave-inl.h"

#include <cmath>
#include <cstring>

HWY_BEFORE_NAMESPACE();
namespace splineloft::lanes::HWY_NAMESPACE {
namespace {

using Doubles = Tag<double>;
using Numbers = Vector<double>;
using Plane = Weave<2, double, double>;

/// A power of two that brings the largest speed there can be so near to 1 that squares neither
/// overflow nor underflow.
double speedScale(const PlaneJetTask& task) {
    double most = 0;
    for (int c = 0; c < 2; ++c) {
        double speed = 0;
        for (int k = 1; k <= task.degree; ++k) {
            speed += k * std::abs(task.coefficients[2 * k + c]);
        }
        most = HWY_MAX(most, speed);
    }
    if (most == 0 || (most > 0x1p-100 && most < 0x1p100)) {
        return 1;
    }
    constexpr int safe = 1000; // 2^safe is finite
    return std::ldexp(1.0, HWY_MIN(HWY_MAX(-std::ilogb(most), -safe), safe));
}

/// 1 / sqrt(v), to a few units of the last place, for v of at least 1e-300.
HWY_INLINE Numbers inverseRoot(Numbers v) {
    const Doubles d;
    const auto one = hn::Set(d, 1.0);
#if HWY_ARCH_X86 && HWY_TARGET != HWY_SCALAR && HWY_TARGET != HWY_EMU128
    // Division and root share one slow unit. Where a float holds v, its instruction gives 11 bits,
    // Newton's step 22, and one of third order all of them.
    if (HWY_LIKELY(hn::AllTrue(d, hn::Ge(v, hn::Set(d, 0x1p-100))))) {
        const hn::Rebind<float, Doubles> floats;
        const auto half = hn::Set(d, 0.5);
        auto root = hn::PromoteTo(d, hn::ApproximateReciprocalSqrt(hn::DemoteTo(floats, v)));
        auto rest = hn::NegMulAdd(hn::Mul(v, root), root, one);
        root = hn::MulAdd(hn::Mul(root, rest), half, root);
        rest = hn::NegMulAdd(hn::Mul(v, root), root, one);
        return hn::MulAdd(hn::Mul(root, rest), hn::MulAdd(rest, hn::Set(d, 0.375), half), root);
    }
#endif
    return hn::Div(one, hn::Sqrt(v));
}

/// One coordinate and its derivatives, the second halved.
struct Coordinate {
    Numbers value, first, halfSecond;
};

/// `fixedDegree` 0: the degree is known at run time only.
template <int fixedDegree>
HWY_INLINE Coordinate coordinateAt(const PlaneJetTask& task, std::size_t which, Numbers u) {
    const Doubles d;
    const double* const c = task.coefficients + which;
    auto k = static_cast<std::size_t>(fixedDegree > 0 ? fixedDegree : task.degree);
    const auto highest = hn::Set(d, c[2 * k]);
    const auto next = hn::MulAdd(highest, u, hn::Set(d, c[2 * k - 2]));
    k -= 2;
    Coordinate at{hn::MulAdd(next, u, hn::Set(d, c[2 * k])), hn::MulAdd(highest, u, next), highest};
    while (k-- > 0) {
        at.halfSecond = hn::MulAdd(at.halfSecond, u, at.first);
        at.first = hn::MulAdd(at.first, u, at.value);
        at.value = hn::MulAdd(at.value, u, hn::Set(d, c[2 * k]));
    }
    return at;
}

/// 0 wherever that is none.
HWY_INLINE Numbers curvatureOf(const Coordinate& x, const Coordinate& y, double scale) {
    const Doubles d;
    const auto by = hn::Set(d, scale);
    const auto x1 = hn::Mul(by, x.first), y1 = hn::Mul(by, y.first);
    const auto x2 = hn::Mul(by, x.halfSecond), y2 = hn::Mul(by, y.halfSecond);
    const auto least = hn::Set(d, 1e-300); // of the scaled speed; its inverse is finite
    const auto square = hn::MulAdd(x1, x1, hn::Mul(y1, y1));
    const auto over = inverseRoot(hn::Max(square, least));
    const auto cross = hn::Sub(hn::Mul(x1, y2), hn::Mul(y1, x2));
    const auto bend = hn::Mul(hn::Mul(hn::Mul(hn::Add(cross, cross), over), over), over);
    const auto curvature = hn::Mul(bend, by);
    const auto isFinite = hn::Le(hn::Abs(curvature), hn::Set(d, 1.7976931348623157e308));
    return hn::IfThenElseZero(hn::And(hn::Ge(square, least), isFinite), curvature);
}

struct Jets {
    double *positions, *firsts, *curvatures;
};

/// Those of one vector of samples, from sample `i` on.
template <int fixedDegree>
HWY_INLINE void jetsOf(const PlaneJetTask& task, std::size_t i, double scale, const Plane& weave,
                       const Jets& to) {
    const auto u = weave.load(task.u + i, 0);
    const auto x = coordinateAt<fixedDegree>(task, 0, u);
    const auto y = coordinateAt<fixedDegree>(task, 1, u);
    weave.store({x.value, y.value}, to.positions);
    weave.store({x.first, y.first}, to.firsts);
    weave.storeOne(curvatureOf(x, y, scale), to.curvatures);
}

/// At a vector of samples at least. Vectors at the ends overlap their neighbours, and write the
/// same again.
template <int fixedDegree>
void manyJets(PlaneJetTask task, const Jets& to) { // a copy, which the output cannot overlap
    const Plane weave;
    const double scale = speedScale(task);
    const auto last = task.count - Plane::lanes;
    const auto head = samplesToLine<2, double>(to.positions);
    auto next = head > 0 ? head : Plane::lanes;
    for (std::size_t i = 0;; next += Plane::lanes) {
        jetsOf<fixedDegree>(task, i, scale, weave,
                            {to.positions + 2 * i, to.firsts + 2 * i, to.curvatures + i});
        if (i == last) {
            return;
        }
        i = HWY_MIN(next, last);
    }
}

void allJets(const PlaneJetTask& task, double* positions, double* firsts, double* curvatures) {
    const Jets to{positions, firsts, curvatures};
    if (task.count < Plane::lanes) {
        HWY_ALIGN double few[5 * Plane::lanes];
        const Jets detour{few, few + 2 * Plane::lanes, few + 4 * Plane::lanes};
        jetsOf<0>(task, 0, speedScale(task), Plane(), detour);
        std::memcpy(to.positions, detour.positions, 2 * task.count * sizeof(double));
        std::memcpy(to.firsts, detour.firsts, 2 * task.count * sizeof(double));
        std::memcpy(to.curvatures, detour.curvatures, task.count * sizeof(double));
    } else if (task.degree == 3) {
        manyJets<3>(task, to);
    } else {
        manyJets<0>(task, to);
    }
}

} // namespace
} // namespace splineloft::lanes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace splineloft::lanes {

HWY_EXPORT(allJets);

void planeJets(const PlaneJetTask& task, double* positions, double* firsts, double* curvatures) {
    HWY_DYNAMIC_DISPATCH(allJets)(task, positions, firsts, curvatures);
}

} // namespace splineloft::lanes
#endif
