#include "core/spline/fast/lanes/spot_lanes.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/spline/fast/lanes/spot_lanes.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h, which compiles what follows several times.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace splineloft::lanes::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using Doubles = hn::ScalableTag<double>;

void locateSpots(const EvenKnots& knots, const double* t, std::size_t count, std::int32_t* pieces,
                 double* u) {
    const Doubles d;
    const auto start = hn::Set(d, knots.start);
    const auto end = hn::Set(d, knots.end);
    const auto interval = hn::Set(d, knots.interval);
    const auto over = hn::Set(d, knots.over);
    const auto last = hn::Set(d, knots.last);
    const auto one = hn::Set(d, 1.0);
    for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
        const auto asked = hn::LoadU(d, t + i);
        const auto low = hn::IfThenElse(hn::Gt(asked, start), asked, start); // NaN goes there too
        const auto inside = hn::Min(low, end);
        auto piece = hn::Floor(hn::Min(hn::Mul(hn::Sub(inside, start), over), last));
        // Rounding may have led to a neighbour.
        const auto early = hn::Lt(inside, hn::MulAdd(piece, interval, start));
        piece = hn::IfThenElse(early, hn::Sub(piece, one), piece);
        const auto next = hn::Add(piece, one);
        const auto late = hn::Ge(inside, hn::MulAdd(next, interval, start));
        piece = hn::IfThenElse(late, hn::Min(next, last), piece);
        const auto along = hn::Mul(hn::Sub(inside, hn::MulAdd(piece, interval, start)), over);
        hn::StoreU(hn::IfThenElse(hn::Ge(inside, end), one, along), d, u + i);
        const hn::Rebind<std::int32_t, Doubles> whole;
        hn::StoreU(hn::DemoteTo(whole, piece), whole, pieces + i);
    }
}

/// Where Horner's scheme begins, and how it goes on from row to row.
struct Path {
    const double* HWY_RESTRICT row;
    std::ptrdiff_t step;
};

template <bool scaled>
HWY_INLINE Path pathOf(const Spots& spots, std::size_t columns, std::size_t i) {
    const auto degree = static_cast<std::size_t>(spots.degree);
    const double* const first =
        spots.coefficients + static_cast<std::size_t>(spots.pieces[i]) * (degree + 1) * columns;
    const auto step = static_cast<std::ptrdiff_t>(columns);
    if (scaled && spots.fromEnd[i] != 0) {
        return {first, step};
    }
    return {first + degree * columns, -step};
}

/// Four spots side by side, whose additions do not wait for each other; columns from `c` on.
/// Degree and columns are template arguments where that pays; otherwise 0.
template <int fixedDegree, bool scaled, class D>
HWY_INLINE void evaluateFour(D d, const Spots& spots, std::size_t columns, std::size_t i,
                             std::size_t c, double* out) {
    const int degree = fixedDegree > 0 ? fixedDegree : spots.degree;
    auto a0 = pathOf<scaled>(spots, columns, i);
    auto a1 = pathOf<scaled>(spots, columns, i + 1);
    auto a2 = pathOf<scaled>(spots, columns, i + 2);
    auto a3 = pathOf<scaled>(spots, columns, i + 3);
    const auto x0 = hn::Set(d, spots.x[i]);
    const auto x1 = hn::Set(d, spots.x[i + 1]);
    const auto x2 = hn::Set(d, spots.x[i + 2]);
    const auto x3 = hn::Set(d, spots.x[i + 3]);
    auto p0 = hn::LoadU(d, a0.row + c);
    auto p1 = hn::LoadU(d, a1.row + c);
    auto p2 = hn::LoadU(d, a2.row + c);
    auto p3 = hn::LoadU(d, a3.row + c);
    for (int k = 0; k < degree; ++k) {
        p0 = hn::MulAdd(p0, x0, hn::LoadU(d, (a0.row += a0.step) + c));
        p1 = hn::MulAdd(p1, x1, hn::LoadU(d, (a1.row += a1.step) + c));
        p2 = hn::MulAdd(p2, x2, hn::LoadU(d, (a2.row += a2.step) + c));
        p3 = hn::MulAdd(p3, x3, hn::LoadU(d, (a3.row += a3.step) + c));
    }
    if (scaled) {
        p0 = hn::Mul(p0, hn::Set(d, spots.scale[i]));
        p1 = hn::Mul(p1, hn::Set(d, spots.scale[i + 1]));
        p2 = hn::Mul(p2, hn::Set(d, spots.scale[i + 2]));
        p3 = hn::Mul(p3, hn::Set(d, spots.scale[i + 3]));
    }
    double* const to = out + i * columns + c;
    hn::StoreU(p0, d, to);
    hn::StoreU(p1, d, to + columns);
    hn::StoreU(p2, d, to + 2 * columns);
    hn::StoreU(p3, d, to + 3 * columns);
}

template <bool scaled, class D>
HWY_INLINE void evaluateOne(D d, const Spots& spots, std::size_t columns, std::size_t i,
                            std::size_t c, double* out) {
    auto path = pathOf<scaled>(spots, columns, i);
    const auto x = hn::Set(d, spots.x[i]);
    auto p = hn::LoadU(d, path.row + c);
    for (int k = 0; k < spots.degree; ++k) {
        p = hn::MulAdd(p, x, hn::LoadU(d, (path.row += path.step) + c));
    }
    if (scaled) {
        p = hn::Mul(p, hn::Set(d, spots.scale[i]));
    }
    hn::StoreU(p, d, out + i * columns + c);
}

template <std::size_t fixedColumns, int fixedDegree, bool scaled>
void evaluateColumns(Spots spots, double* out) { // a copy, which the output cannot overlap
    const hn::CappedTag<double, fixedColumns == 0 ? 4 : fixedColumns> d;
    const auto columns = fixedColumns > 0 ? fixedColumns : spots.columns;
    std::size_t i = 0;
    for (; i + 4 <= spots.count; i += 4) {
        for (std::size_t c = 0; c < columns; c += hn::Lanes(d)) {
            evaluateFour<fixedDegree, scaled>(d, spots, columns, i, c, out);
        }
    }
    for (; i < spots.count; ++i) {
        for (std::size_t c = 0; c < columns; c += hn::Lanes(d)) {
            evaluateOne<scaled>(d, spots, columns, i, c, out);
        }
    }
}

template <std::size_t fixedColumns> void evaluateDegree(const Spots& spots, double* out) {
    if (spots.scale != nullptr) {
        evaluateColumns<fixedColumns, 0, true>(spots, out);
    } else if (spots.degree == 3) {
        evaluateColumns<fixedColumns, 3, false>(spots, out);
    } else {
        evaluateColumns<fixedColumns, 0, false>(spots, out);
    }
}

void evaluateMany(const Spots& spots, double* out) {
    switch (spots.columns) {
    case 1: return evaluateDegree<1>(spots, out);
    case 2: return evaluateDegree<2>(spots, out);
    case 4: return evaluateDegree<4>(spots, out);
    default: return evaluateDegree<0>(spots, out);
    }
}

/// One column. Scaled coefficients are chosen lane by lane from the two ends.
template <bool scaled> void evaluateColumn(const Spots& spots, std::size_t c, double* out) {
    const Doubles d;
    const auto degree = static_cast<std::size_t>(spots.degree);
    const double* const first = spots.coefficients + c;
    const double* const last = first + degree * spots.columns;
    const auto lanes = hn::Lanes(d);
    for (std::size_t i = 0; i < spots.count; i += 2 * lanes) {
        const auto x0 = hn::LoadU(d, spots.x + i);
        const auto x1 = hn::LoadU(d, spots.x + i + lanes);
        auto p0 = hn::Zero(d);
        auto p1 = hn::Zero(d);
        if (scaled) {
            const auto half = hn::Set(d, 0.5);
            const auto end0 = hn::Gt(hn::LoadU(d, spots.fromEnd + i), half);
            const auto end1 = hn::Gt(hn::LoadU(d, spots.fromEnd + i + lanes), half);
            for (std::size_t k = 0; k <= degree; ++k) {
                const auto up = hn::Set(d, first[k * spots.columns]);
                const auto down = hn::Set(d, *(last - k * spots.columns));
                p0 = hn::MulAdd(p0, x0, hn::IfThenElse(end0, up, down));
                p1 = hn::MulAdd(p1, x1, hn::IfThenElse(end1, up, down));
            }
            p0 = hn::Mul(p0, hn::LoadU(d, spots.scale + i));
            p1 = hn::Mul(p1, hn::LoadU(d, spots.scale + i + lanes));
        } else {
            for (std::size_t k = 0; k <= degree; ++k) {
                const auto down = hn::Set(d, *(last - k * spots.columns));
                p0 = hn::MulAdd(p0, x0, down);
                p1 = hn::MulAdd(p1, x1, down);
            }
        }
        hn::StoreU(p0, d, out + i);
        hn::StoreU(p1, d, out + i + lanes);
    }
}

void evaluateOnePiece(const Spots& spots, std::size_t width, std::size_t stride, double* out) {
    for (std::size_t c = 0; c < width; ++c) {
        if (spots.scale != nullptr) {
            evaluateColumn<true>(spots, c, out + c * stride);
        } else {
            evaluateColumn<false>(spots, c, out + c * stride);
        }
    }
}

} // namespace
} // namespace splineloft::lanes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace splineloft::lanes {

HWY_EXPORT(locateSpots);
HWY_EXPORT(evaluateMany);
HWY_EXPORT(evaluateOnePiece);

void locateEvenly(const EvenKnots& knots, const double* t, std::size_t count, std::int32_t* pieces,
                  double* u) {
    HWY_DYNAMIC_DISPATCH(locateSpots)(knots, t, count, pieces, u);
}

void evaluateSpots(const Spots& spots, double* out) {
    HWY_DYNAMIC_DISPATCH(evaluateMany)(spots, out);
}

void evaluateSpotsOfOnePiece(const Spots& spots, std::size_t width, std::size_t stride,
                             double* out) {
    HWY_DYNAMIC_DISPATCH(evaluateOnePiece)(spots, width, stride, out);
}

} // namespace splineloft::lanes
#endif
