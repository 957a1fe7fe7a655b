#include "core/spline/fast/lanes/natural_lanes.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/spline/fast/lanes/natural_lanes.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h, which compiles what follows several times.
#include <hwy/highway.h>

#include <cmath>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace splineloft::lanes::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using Doubles = hn::ScalableTag<double>;

/// Fills in `rises` and `leastInterval`.
void surveyX(const double* x, std::size_t count, Survey& survey) {
    const Doubles d;
    const auto lanes = hn::Lanes(d);
    const auto zero = hn::Zero(d);
    auto rises = hn::Eq(zero, zero);
    auto least = hn::Inf(d);
    std::size_t i = 1;
    for (; i + lanes <= count; i += lanes) {
        const auto interval = hn::Sub(hn::LoadU(d, x + i), hn::LoadU(d, x + i - 1));
        rises = hn::And(rises, hn::Gt(interval, zero)); // which nothing is that is no number
        least = hn::Min(least, interval);
    }
    survey.rises = hn::AllTrue(d, rises);
    survey.leastInterval = hn::GetLane(hn::MinOfLanes(d, least));
    for (; i < count; ++i) {
        survey.rises = survey.rises && x[i] - x[i - 1] > 0;
        survey.leastInterval = HWY_MIN(survey.leastInterval, x[i] - x[i - 1]);
    }
}

bool allBelow(const double* y, std::size_t count, double most) {
    const Doubles d;
    const auto lanes = hn::Lanes(d);
    const auto limit = hn::Set(d, most);
    auto below = hn::Eq(limit, limit);
    std::size_t i = 0;
    for (; i + lanes <= count; i += lanes) {
        below = hn::And(below, hn::Lt(hn::Abs(hn::LoadU(d, y + i)), limit));
    }
    bool result = hn::AllTrue(d, below);
    for (; i < count; ++i) {
        result = result && std::abs(y[i]) < most;
    }
    return result;
}

void survey(const double* x, const double* y, std::size_t count, double most, Survey& survey) {
    surveyX(x, count, survey);
    survey.isModest = allBelow(y, count, most);
}

void measure(const double* x, const double* y, std::size_t pieces, double* HWY_RESTRICT intervals,
             double* HWY_RESTRICT chords) {
    const Doubles d;
    const auto lanes = hn::Lanes(d);
    std::size_t k = 0;
    for (; k + lanes <= pieces; k += lanes) {
        const auto interval = hn::Sub(hn::LoadU(d, x + k + 1), hn::LoadU(d, x + k));
        const auto rise = hn::Sub(hn::LoadU(d, y + k + 1), hn::LoadU(d, y + k));
        hn::StoreU(interval, d, intervals + k);
        hn::StoreU(hn::Div(rise, interval), d, chords + k);
    }
    for (; k < pieces; ++k) {
        intervals[k] = x[k + 1] - x[k];
        chords[k] = (y[k + 1] - y[k]) / intervals[k];
    }
}

void form(const double* intervals, const double* chords, std::size_t rows,
          double* HWY_RESTRICT diagonal, double* HWY_RESTRICT right) {
    const Doubles d;
    const auto lanes = hn::Lanes(d);
    const auto two = hn::Set(d, 2.0);
    const auto three = hn::Set(d, 3.0);
    std::size_t k = 0;
    for (; k + lanes <= rows; k += lanes) {
        const auto before = hn::LoadU(d, intervals + k);
        const auto after = hn::LoadU(d, intervals + k + 1);
        const auto sum = hn::MulAdd(after, hn::LoadU(d, chords + k),
                                    hn::Mul(before, hn::LoadU(d, chords + k + 1)));
        hn::StoreU(hn::Mul(two, hn::Add(before, after)), d, diagonal + k);
        hn::StoreU(hn::Mul(three, sum), d, right + k);
    }
    for (; k < rows; ++k) {
        diagonal[k] = 2 * (intervals[k] + intervals[k + 1]);
        right[k] = 3 * (intervals[k + 1] * chords[k] + intervals[k] * chords[k + 1]);
    }
}

} // namespace
} // namespace splineloft::lanes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace splineloft::lanes {

HWY_EXPORT(survey);
HWY_EXPORT(measure);
HWY_EXPORT(form);

Survey surveyOf(const double* x, const double* y, std::size_t count, double most) {
    Survey result;
    HWY_DYNAMIC_DISPATCH(survey)(x, y, count, most, result);
    return result;
}

void measureChords(const double* x, const double* y, std::size_t pieces, double* intervals,
                   double* chords) {
    HWY_DYNAMIC_DISPATCH(measure)(x, y, pieces, intervals, chords);
}

void formSlopeRows(const double* intervals, const double* chords, std::size_t rows,
                   double* diagonal, double* right) {
    HWY_DYNAMIC_DISPATCH(form)(intervals, chords, rows, diagonal, right);
}

} // namespace splineloft::lanes
#endif
