#include "core/spline/fast/lanes/dense_lanes.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/spline/fast/lanes/dense_lanes.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h, which compiles what follows several times.
#include <hwy/cache_control.h>
#include <hwy/highway.h>

#include <cstring>

HWY_BEFORE_NAMESPACE();
namespace splineloft::lanes::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using Doubles = hn::ScalableTag<double>;
using Vector = hn::Vec<Doubles>;

/// Horner's scheme for four vectors of samples, whose additions do not wait for each other.
/// `fixedDegree` 0: the degree is known at run time only.
template <int fixedDegree, class Number, class V>
HWY_INLINE void horner(Doubles d, const Task<Number>& task, const double* HWY_RESTRICT c, V x0,
                       V x1, V x2, V x3, V& p0, V& p1, V& p2, V& p3) {
    const auto row = task.rowStride;
    auto k = static_cast<std::size_t>(fixedDegree > 0 ? fixedDegree : task.degree);
    p0 = p1 = p2 = p3 = hn::Set(d, c[k * row]);
    while (k-- > 0) {
        const auto next = hn::Set(d, c[k * row]);
        p0 = hn::MulAdd(p0, x0, next);
        p1 = hn::MulAdd(p1, x1, next);
        p2 = hn::MulAdd(p2, x2, next);
        p3 = hn::MulAdd(p3, x3, next);
    }
}

template <class Number, class V>
HWY_INLINE V horner(Doubles d, const Task<Number>& task, const double* HWY_RESTRICT c, V x) {
    auto k = static_cast<std::size_t>(task.degree);
    auto p = hn::Set(d, c[k * task.rowStride]);
    while (k-- > 0) {
        p = hn::MulAdd(p, x, hn::Set(d, c[k * task.rowStride]));
    }
    return p;
}

HWY_INLINE void scaleFour(const double* scale, Vector& p0, Vector& p1, Vector& p2, Vector& p3) {
    const Doubles d;
    const auto lanes = hn::Lanes(d);
    p0 = hn::Mul(p0, hn::LoadU(d, scale));
    p1 = hn::Mul(p1, hn::LoadU(d, scale + lanes));
    p2 = hn::Mul(p2, hn::LoadU(d, scale + 2 * lanes));
    p3 = hn::Mul(p3, hn::LoadU(d, scale + 3 * lanes));
}

/// Where within a vector's samples lane `lane` stands when pairs of Number are to be interleaved.
template <class Number> std::size_t sampleOfLane(std::size_t lane, std::size_t lanes) {
    const auto block = HWY_MIN(16 / sizeof(Number), lanes); // lanes that interleave together
    const auto half = block / 2;
    if (half == 0) {
        return lane;
    }
    const auto within = lane % block;
    const auto lower = lane / block * half;
    return within < half ? lower + within : lanes / 2 + lower + within - half;
}

template <class Number> void arrange(double* table, std::size_t count) {
    constexpr std::size_t mostLanes = HWY_MAX_BYTES / sizeof(double);
    const auto lanes = hn::Lanes(Doubles());
    std::size_t order[mostLanes]; // worked out once: it takes divisions
    for (std::size_t lane = 0; lane < lanes; ++lane) {
        order[lane] = sampleOfLane<Number>(lane, lanes);
    }
    HWY_ALIGN double samples[mostLanes];
    for (std::size_t i = 0; i < count; i += lanes) {
        hn::Store(hn::LoadU(Doubles(), table + i), Doubles(), samples);
        for (std::size_t lane = 0; lane < lanes; ++lane) {
            table[i + lane] = samples[order[lane]];
        }
    }
}

/// As many numbers as there are lanes of doubles.
template <class Number> using Numbers = hn::Rebind<Number, Doubles>;

HWY_INLINE Vector rounded(Vector v, double) {
    return v;
}
HWY_INLINE hn::Vec<Numbers<float>> rounded(Vector v, float) {
    return hn::DemoteTo(Numbers<float>(), v);
}

template <class Number> HWY_INLINE void storeRows(Vector x, Number* HWY_RESTRICT out) {
    hn::StoreU(rounded(x, Number{}), Numbers<Number>(), out);
}

template <class Number> HWY_INLINE void storeRows(Vector x, Vector y, Number* HWY_RESTRICT out) {
    const Numbers<Number> d;
    const auto p = rounded(x, Number{});
    const auto q = rounded(y, Number{});
#if HWY_TARGET == HWY_SCALAR
    hn::StoreInterleaved2(p, q, d, out);
#else
    hn::StoreU(hn::InterleaveLower(d, p, q), d, out);
    hn::StoreU(hn::InterleaveUpper(d, p, q), d, out + hn::Lanes(d));
#endif
}

template <class Number>
HWY_INLINE void storeRows(Vector x, Vector y, Vector z, Number* HWY_RESTRICT out) {
    hn::StoreInterleaved3(rounded(x, Number{}), rounded(y, Number{}), rounded(z, Number{}),
                          Numbers<Number>(), out);
}

/// The coordinates of one vector of samples.
template <int dimension, class Number>
HWY_INLINE void sampleVector(const Task<Number>& task, const double* c, std::size_t i,
                             Number* HWY_RESTRICT out) {
    const Doubles d;
    const auto x = hn::LoadU(d, task.x + i);
    const auto s = task.scale == nullptr ? hn::Set(d, 1.0) : hn::LoadU(d, task.scale + i);
    const auto p = hn::Mul(horner(d, task, c, x), s);
    if constexpr (dimension == 1) {
        storeRows(p, out);
    } else if constexpr (dimension == 2) {
        storeRows(p, hn::Mul(horner(d, task, c + 1, x), s), out);
    } else {
        storeRows(p, hn::Mul(horner(d, task, c + 1, x), s), hn::Mul(horner(d, task, c + 2, x), s),
                  out);
    }
}

/// The same of four vectors. (Vectors of some machines have no size that the compiler knows, so
/// that they cannot stand in arrays.)
template <int dimension, int fixedDegree, bool scaled, class Number>
HWY_INLINE void sampleFour(const Task<Number>& task, const double* c, std::size_t i,
                           Number* HWY_RESTRICT out) {
    const Doubles d;
    const auto lanes = hn::Lanes(d);
    const auto x0 = hn::LoadU(d, task.x + i);
    const auto x1 = hn::LoadU(d, task.x + i + lanes);
    const auto x2 = hn::LoadU(d, task.x + i + 2 * lanes);
    const auto x3 = hn::LoadU(d, task.x + i + 3 * lanes);
    Vector p0, p1, p2, p3, q0, q1, q2, q3, r0, r1, r2, r3;
    horner<fixedDegree>(d, task, c, x0, x1, x2, x3, p0, p1, p2, p3);
    if constexpr (dimension > 1) {
        horner<fixedDegree>(d, task, c + 1, x0, x1, x2, x3, q0, q1, q2, q3);
    }
    if constexpr (dimension > 2) {
        horner<fixedDegree>(d, task, c + 2, x0, x1, x2, x3, r0, r1, r2, r3);
    }
    if constexpr (scaled) {
        scaleFour(task.scale + i, p0, p1, p2, p3);
        if constexpr (dimension > 1) {
            scaleFour(task.scale + i, q0, q1, q2, q3);
        }
        if constexpr (dimension > 2) {
            scaleFour(task.scale + i, r0, r1, r2, r3);
        }
    }
    if constexpr (dimension == 1) {
        storeRows(p0, out);
        storeRows(p1, out + lanes);
        storeRows(p2, out + 2 * lanes);
        storeRows(p3, out + 3 * lanes);
    } else if constexpr (dimension == 2) {
        storeRows(p0, q0, out);
        storeRows(p1, q1, out + 2 * lanes);
        storeRows(p2, q2, out + 4 * lanes);
        storeRows(p3, q3, out + 6 * lanes);
    } else {
        storeRows(p0, q0, r0, out);
        storeRows(p1, q1, r1, out + 3 * lanes);
        storeRows(p2, q2, r2, out + 6 * lanes);
        storeRows(p3, q3, r3, out + 9 * lanes);
    }
}

/// What four vectors leave over. The last vector may reach into samples that are written later;
/// where it would reach beyond the end, it takes a detour.
template <int dimension, class Number>
HWY_INLINE void sampleRest(const Task<Number>& task, const double* c, std::size_t i, Number* out) {
    const auto lanes = hn::Lanes(Doubles());
    for (; i < task.count; i += lanes) {
        Number* const to = out + i * dimension;
        if (static_cast<std::size_t>(task.end - to) >= lanes * dimension) {
            sampleVector<dimension>(task, c, i, to);
        } else {
            HWY_ALIGN Number detour[HWY_MAX_BYTES / sizeof(double) * dimension];
            sampleVector<dimension>(task, c, i, detour);
            std::memcpy(to, detour, (task.count - i) * dimension * sizeof(Number));
        }
    }
}

template <int dimension, int fixedDegree, bool scaled, class Number>
void samplePieces(Task<Number> task) { // a copy, which the output cannot overlap
    const auto four = 4 * hn::Lanes(Doubles());
    for (std::size_t piece = 0; piece < task.pieces; ++piece) {
        const double* const c = task.coefficients + piece * task.pieceStride;
        Number* const out = task.out + piece * task.outStride;
        std::size_t i = 0;
        for (; i + four <= task.count; i += four) {
            sampleFour<dimension, fixedDegree, scaled>(task, c, i, out + i * dimension);
        }
        sampleRest<dimension>(task, c, i, out);
    }
}

template <int dimension, class Number> void sampleDegree(const Task<Number>& task) {
    if (task.scale != nullptr) {
        samplePieces<dimension, 0, true>(task);
    } else if (task.degree == 3) {
        samplePieces<dimension, 3, false>(task);
    } else {
        samplePieces<dimension, 0, false>(task);
    }
}

template <class Number> void sample(const Task<Number>& task, int dimension) {
    switch (dimension) {
    case 1: return sampleDegree<1>(task);
    case 2: return sampleDegree<2>(task);
    default: return sampleDegree<3>(task);
    }
}

/// Lines of the cache are written whole; the parts before the first and after the last are not
/// streamed.
template <class Number>
void stream(const Number* HWY_RESTRICT from, std::size_t count, Number* HWY_RESTRICT to) {
    constexpr std::size_t line = 64;
    const hn::ScalableTag<Number> d;
    const auto lanes = hn::Lanes(d);
    const auto beyond = reinterpret_cast<std::uintptr_t>(to) % line;
    const auto head = HWY_MIN(count, (line - beyond) % line / sizeof(Number));
    std::memcpy(to, from, head * sizeof(Number));
    std::size_t i = head;
    for (; i + lanes <= count; i += lanes) {
        hn::Stream(hn::LoadU(d, from + i), d, to + i);
    }
    std::memcpy(to + i, from + i, (count - i) * sizeof(Number));
    hwy::FlushStream();
}

void arrangeDouble(double* table, std::size_t count) {
    arrange<double>(table, count);
}
void arrangeFloat(double* table, std::size_t count) {
    arrange<float>(table, count);
}
void sampleDouble(const Task<double>& task, int dimension) {
    sample(task, dimension);
}
void sampleFloat(const Task<float>& task, int dimension) {
    sample(task, dimension);
}
void streamDouble(const double* from, std::size_t count, double* to) {
    stream(from, count, to);
}
void streamFloat(const float* from, std::size_t count, float* to) {
    stream(from, count, to);
}

} // namespace
} // namespace splineloft::lanes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace splineloft::lanes {

HWY_EXPORT(arrangeDouble);
HWY_EXPORT(arrangeFloat);
HWY_EXPORT(sampleDouble);
HWY_EXPORT(sampleFloat);
HWY_EXPORT(streamDouble);
HWY_EXPORT(streamFloat);

template <> void arrangeForPairs<double>(double* table, std::size_t count) {
    HWY_DYNAMIC_DISPATCH(arrangeDouble)(table, count);
}

template <> void arrangeForPairs<float>(double* table, std::size_t count) {
    HWY_DYNAMIC_DISPATCH(arrangeFloat)(table, count);
}

void samplePoints(const Task<double>& task, int dimension) {
    HWY_DYNAMIC_DISPATCH(sampleDouble)(task, dimension);
}

void samplePoints(const Task<float>& task, int dimension) {
    HWY_DYNAMIC_DISPATCH(sampleFloat)(task, dimension);
}

void streamCopy(const double* from, std::size_t count, double* to) {
    HWY_DYNAMIC_DISPATCH(streamDouble)(from, count, to);
}

void streamCopy(const float* from, std::size_t count, float* to) {
    HWY_DYNAMIC_DISPATCH(streamFloat)(from, count, to);
}

} // namespace splineloft::lanes
#endif
