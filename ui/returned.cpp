#include "ui/returned.h"

#include "core/document/handles.h"

#include <algorithm>
#include <numeric>

namespace splineloft::ui {
namespace {

using Indices = std::vector<std::size_t>;

/// The members of `more` between which those of `fewer` stand in their order, told by
/// `same(of fewer, of more)`; none where some of `fewer` are not there.
template <class Same> Indices additions(std::size_t fewer, std::size_t more, Same same) {
    Indices added;
    std::size_t matched = 0;
    for (std::size_t i = 0; i < more; ++i) {
        if (matched < fewer && same(matched, i)) {
            ++matched;
        } else {
            added.push_back(i);
        }
    }
    return matched == fewer ? added : Indices();
}

Indices addedPoints(const Curve& before, const Curve& after) {
    if (before.points.dimension() != after.points.dimension()) {
        return {};
    }
    const auto samePlace = [&](std::size_t i, std::size_t j) {
        return std::ranges::equal(before.points[i], after.points[j]);
    };
    return additions(before.points.size(), after.points.size(), samePlace);
}

void select(Returned& result, std::size_t curve, const Curve& as, Indices points) {
    const auto isHandle = [&](std::size_t i) { return anchorOf(as, i).has_value(); };
    if (!std::ranges::all_of(points, isHandle)) {
        std::erase_if(points, isHandle);
    }
    for (const auto i : points) {
        result.points.push_back({curve, i, Part::point});
    }
}

} // namespace

Returned returned(const Document& before, const Document& after) {
    Returned result;
    if (before.curves.size() == after.curves.size()) {
        for (std::size_t c = 0; c < after.curves.size(); ++c) {
            const auto& was = before.curves[c].curve;
            const auto& is = after.curves[c].curve;
            if (was != is && was->points.size() < is->points.size()) {
                select(result, c, *is, addedPoints(*was, *is));
            }
        }
        return result;
    }
    const auto sameCurve = [&](std::size_t i, std::size_t j) {
        return before.curves[i].curve == after.curves[j].curve;
    };
    for (const auto c : additions(before.curves.size(), after.curves.size(), sameCurve)) {
        const Curve& curve = *after.curves[c];
        Indices all(curve.points.size());
        std::iota(all.begin(), all.end(), 0U);
        select(result, c, curve, std::move(all));
        result.curve = c;
    }
    return result;
}

} // namespace splineloft::ui
