#include "core/spline/fast/lanes/dense_lanes.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/spline/fast/lanes/dense_lanes.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h, which compiles what follows several times.
#include <hwy/cache_control.h>
#include <hwy/highway.h>

#include "core/spline/fast/lanes/weave-inl.h"

#include <cstring>
#include <type_traits>

HWY_BEFORE_NAMESPACE();
namespace splineloft::lanes::HWY_NAMESPACE {
namespace {

/// Horner's scheme for some vectors of samples, whose additions do not wait for each other.
template <std::size_t vectors, int dimension, class Lane, class Number>
HWY_INLINE void sampleVectors(const Task<Lane, Number>& task, const Lane* HWY_RESTRICT c,
                              std::size_t i, const Weave<dimension, Lane, Number>& weave,
                              Number* HWY_RESTRICT out) {
    const Tag<Lane> d;
    constexpr auto lanes = Weave<dimension, Lane, Number>::lanes;
    Vector<Lane> p[vectors][dimension];
    for (std::size_t which = 0; which < dimension; ++which) {
        Vector<Lane> x[vectors];
        auto k = static_cast<std::size_t>(task.degree);
        for (std::size_t v = 0; v < vectors; ++v) {
            x[v] = weave.load(task.x + i + v * lanes, which);
            p[v][which] = hn::Set(d, c[k * task.rowStride + which]);
        }
        while (k-- > 0) {
            const auto next = hn::Set(d, c[k * task.rowStride + which]);
            for (std::size_t v = 0; v < vectors; ++v) {
                p[v][which] = hn::MulAdd(p[v][which], x[v], next);
            }
        }
        for (std::size_t v = 0; v < vectors && task.scale != nullptr; ++v) {
            const auto scale = weave.load(task.scale + i + v * lanes, which);
            p[v][which] = hn::Mul(p[v][which], scale);
        }
    }
    for (std::size_t v = 0; v < vectors; ++v) {
        weave.store(p[v], out + v * lanes * dimension);
    }
}

/// `count` samples, a vector at least, of a polynomial of any degree. Vectors at the ends overlap
/// their neighbours, and write the same again.
template <int dimension, class Lane, class Number>
void samplePiece(const Task<Lane, Number>& task, const Lane* c, std::size_t head,
                 const Weave<dimension, Lane, Number>& weave, Number* out) {
    constexpr auto lanes = Weave<dimension, Lane, Number>::lanes;
    const auto last = task.count - lanes;
    if (head > 0) {
        sampleVectors<1>(task, c, 0, weave, out);
    }
    std::size_t i = head;
    for (; i + 3 * lanes <= last; i += 4 * lanes) {
        sampleVectors<4>(task, c, i, weave, out + i * dimension);
    }
    for (; i <= last; i += lanes) {
        sampleVectors<1>(task, c, i, weave, out + i * dimension);
    }
    if (i < task.count) {
        sampleVectors<1>(task, c, last, weave, out + last * dimension);
    }
}

#define SPLINELOFT_INLINE HWY_ATTR __attribute__((always_inline))

/// The same of a cubic in power form. All that the loop needs is a local of it (the weave, too, is
/// a copy), so stays in registers, and the processor works on several vectors at once by itself.
/// `arranged`, if it is there, is the table in the order of the lanes, from `head` on.
template <int dimension, bool isArranged, class Lane, class Number>
void sampleCubic(const Task<Lane, Number>& task, const Lane* c, std::size_t head,
                 const Lane* arranged, Weave<dimension, Lane, Number> weave, Number* out) {
    const Tag<Lane> d;
    constexpr auto lanes = Weave<dimension, Lane, Number>::lanes;
    const Lane* const table = task.x;
    Vector<Lane> c0[dimension], c1[dimension], c2[dimension], c3[dimension];
    for (std::size_t which = 0; which < dimension; ++which) {
        c0[which] = hn::Set(d, c[which]);
        c1[which] = hn::Set(d, c[task.rowStride + which]);
        c2[which] = hn::Set(d, c[2 * task.rowStride + which]);
        c3[which] = hn::Set(d, c[3 * task.rowStride + which]);
    }
    const auto points = [&](std::size_t i, auto isReady) SPLINELOFT_INLINE {
        Vector<Lane> p[dimension];
        for (std::size_t which = 0; which < dimension; ++which) {
            const auto x =
                isReady.value ? hn::LoadU(d, arranged + i) : weave.load(table + i, which);
            p[which] = hn::MulAdd(hn::MulAdd(c3[which], x, c2[which]), x, c1[which]);
            p[which] = hn::MulAdd(p[which], x, c0[which]);
        }
        weave.store(p, out + i * dimension);
    };
    constexpr std::bool_constant<isArranged> ready;
    const auto last = task.count - lanes;
    points(0, std::false_type());
    auto i = head > 0 ? head : lanes;
    for (; i + lanes < last; i += 2 * lanes) {
        points(i, ready);
        points(i + lanes, ready);
    }
    if (i < last) {
        points(i, ready);
    }
    points(last, std::false_type());
}

template <int dimension, class Lane, class Number>
void samplePieces(Task<Lane, Number> task) { // a copy, which the output cannot overlap
    const Weave<dimension, Lane, Number> weave;
    constexpr auto lanes = Weave<dimension, Lane, Number>::lanes;
    const bool isCubic = task.degree == 3 && task.scale == nullptr;
    const bool alike = task.outStride % lanes == 0; // all pieces begin alike in their lines
    auto head = samplesToLine<dimension, Lane>(task.out);

    // What is the same for all pieces is brought into order once.
    constexpr std::size_t mostArranged = 512;
    HWY_ALIGN Lane table[mostArranged + lanes];
    const Lane* const arranged = table + (lanes - head) % lanes;
    const bool isArranged =
        dimension == 2 && isCubic && alike && task.pieces > 2 && task.count <= mostArranged;
    for (auto i = head; isArranged && i + lanes <= task.count; i += lanes) {
        hn::StoreU(weave.load(task.x + i, 0), Tag<Lane>(), table + (lanes - head) % lanes + i);
    }

    for (std::size_t piece = 0; piece < task.pieces; ++piece) {
        const Lane* const c = task.coefficients + piece * task.pieceStride;
        Number* const out = task.out + piece * task.outStride;
        head = alike ? head : samplesToLine<dimension, Lane>(out);
        if (task.count < lanes) {
            HWY_ALIGN Number few[lanes * dimension];
            sampleVectors<1>(task, c, 0, weave, few);
            std::memcpy(out, few, task.count * dimension * sizeof(Number));
        } else if (isArranged) {
            sampleCubic<dimension, true>(task, c, head, arranged, weave, out);
        } else if (isCubic) {
            sampleCubic<dimension, false>(task, c, head, arranged, weave, out);
        } else {
            samplePiece(task, c, head, weave, out);
        }
        for (std::size_t k = 0; k < dimension && task.starts != nullptr; ++k) {
            out[k] = task.starts[piece * task.pieceStride + k];
        }
    }
}

template <class Lane, class Number>
HWY_INLINE void sample(const Task<Lane, Number>& task, int dimension) {
    switch (dimension) {
    case 1: return samplePieces<1>(task);
    case 2: return samplePieces<2>(task);
    default: return samplePieces<3>(task);
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

void sampleDouble(const Task<double, double>& task, int dimension) {
    sample(task, dimension);
}
void sampleRounded(const Task<double, float>& task, int dimension) {
    sample(task, dimension);
}
void sampleFloat(const Task<float, float>& task, int dimension) {
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

HWY_EXPORT(sampleDouble);
HWY_EXPORT(sampleRounded);
HWY_EXPORT(sampleFloat);
HWY_EXPORT(streamDouble);
HWY_EXPORT(streamFloat);

void samplePoints(const Task<double, double>& task, int dimension) {
    HWY_DYNAMIC_DISPATCH(sampleDouble)(task, dimension);
}

void samplePoints(const Task<double, float>& task, int dimension) {
    HWY_DYNAMIC_DISPATCH(sampleRounded)(task, dimension);
}

void samplePoints(const Task<float, float>& task, int dimension) {
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
