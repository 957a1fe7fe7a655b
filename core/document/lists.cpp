#include "core/document/lists.h"

#include "core/spline/catalog.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace splineloft {
namespace {

/// Calls `change(list, mean)` for each list of one value a point; `mean` is of two neighbours.
template <class Change> void eachList(Curve& curve, Change change) {
    if (!curve.weights.empty()) {
        change(curve.weights, [](double a, double b) { return std::sqrt(a * b); });
    }
    for (auto& [key, values] : curve.local) {
        change(values, [](double a, double b) { return 0.5 * (a + b); });
    }
}

/// Knots before and after those at which the curve may have joints.
std::size_t outerKnots(const Curve& curve) {
    return curve.closed ? 0 : static_cast<std::size_t>(parameterOf(curve, "degree"));
}

/// The knot in the middle of what control point `index` pulls.
std::size_t middleKnot(const Curve& curve, std::size_t index) {
    return index + (outerKnots(curve) + 1) / 2;
}

/// Halves the interval before knot `near`, or the first that can be halved where that one cannot.
/// Gives the knots up where there is none.
void addKnot(Curve& curve, std::size_t near) {
    auto& knots = curve.knots;
    const auto first = outerKnots(curve) + 1;
    if (knots.size() < 2 * first) {
        return dropKnots(curve); // too few points for an interval
    }
    const auto last = knots.size() - first;
    const auto middle = [&](std::size_t i) { return 0.5 * knots[i - 1] + 0.5 * knots[i]; };
    const auto hasRoom = [&](std::size_t i) {
        return knots[i - 1] < middle(i) && middle(i) < knots[i];
    };
    auto at = std::clamp(near, first, last);
    for (auto i = first; i <= last && !hasRoom(at); ++i) {
        at = i;
    }
    if (!hasRoom(at)) {
        return dropKnots(curve);
    }
    const double halfway = middle(at);
    knots.insert(knots.begin() + static_cast<std::ptrdiff_t>(at), halfway);
}

/// Removes an inner knot; all of them where there is none left.
void removeKnot(Curve& curve, std::size_t near) {
    auto& knots = curve.knots;
    const auto first = outerKnots(curve) + 1;
    const auto last = knots.size() - first;
    if (first < last) {
        const auto at = std::clamp(near, first, last - 1);
        knots.erase(knots.begin() + static_cast<std::ptrdiff_t>(at));
    } else {
        dropKnots(curve);
    }
}

} // namespace

void addToLists(Curve& curve, std::size_t index) {
    eachList(curve, [&](std::vector<double>& values, auto mean) {
        const auto n = values.size();
        const auto before = index > 0 ? index - 1 : curve.closed ? n - 1 : 0;
        const auto after = index < n ? index : curve.closed ? 0 : n - 1;
        values.insert(values.begin() + static_cast<std::ptrdiff_t>(index),
                      mean(values[before], values[after]));
    });
    if (!curve.knots.empty()) {
        addKnot(curve, middleKnot(curve, index));
    }
}

void removeFromLists(Curve& curve, const std::set<std::size_t>& indices) {
    for (auto index = indices.rbegin(); index != indices.rend(); ++index) {
        eachList(curve, [&](std::vector<double>& values, auto) {
            values.erase(values.begin() + static_cast<std::ptrdiff_t>(*index));
        });
        if (!curve.knots.empty()) {
            removeKnot(curve, middleKnot(curve, *index));
        }
    }
    std::erase_if(curve.local, [](const auto& entry) { return entry.second.empty(); });
}

void dropKnots(Curve& curve) {
    curve.knots.clear();
    const auto& accepted = familyOf(curve).ends;
    if (std::ranges::find(accepted, curve.ends) == accepted.end()) {
        curve.ends = accepted.front();
    }
}

void dropUnusedLists(Curve& curve) {
    const auto& family = familyOf(curve);
    if (!family.usesWeights) {
        curve.weights.clear();
    }
    if (!family.usesKnots) {
        dropKnots(curve);
    }
    std::erase_if(curve.local, [&](const auto& entry) {
        const auto found = std::ranges::find(family.parameters, entry.first, &Parameter::key);
        return found == family.parameters.end() || !found->local;
    });
}

} // namespace splineloft
