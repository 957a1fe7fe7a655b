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

// The least intervals of so many vectors are found side by side: one would wait for itself.
constexpr std::size_t vectors = 4;

/// Fills in `rises` and `leastInterval`.
void surveyX(const double* x, std::size_t count, Survey& survey) {
    const Doubles d;
    const auto lanes = hn::Lanes(d);
    survey.leastInterval = std::numeric_limits<double>::infinity();
    const auto zero = hn::Zero(d);
    auto rises = hn::Eq(zero, zero);
    hn::Vec<Doubles> least[vectors];
    for (auto& some : least) {
        some = hn::Inf(d);
    }
    std::size_t i = 1;
    for (; i + vectors * lanes <= count; i += vectors * lanes) {
        for (std::size_t v = 0; v < vectors; ++v) {
            const double* const from = x + i + v * lanes;
            const auto interval = hn::Sub(hn::LoadU(d, from), hn::LoadU(d, from - 1));
            rises = hn::And(rises, hn::Gt(interval, zero)); // which nothing is that is no number
            least[v] = hn::Min(least[v], interval);
        }
    }
    survey.rises = hn::AllTrue(d, rises);
    for (const auto& some : least) {
        survey.leastInterval = HWY_MIN(survey.leastInterval, hn::GetLane(hn::MinOfLanes(d, some)));
    }
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

} // namespace
} // namespace splineloft::lanes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace splineloft::lanes {

HWY_EXPORT(survey);

Survey surveyOf(const double* x, const double* y, std::size_t count, double most) {
    Survey result;
    HWY_DYNAMIC_DISPATCH(survey)(x, y, count, most, result);
    return result;
}

} // namespace splineloft::lanes
#endif
