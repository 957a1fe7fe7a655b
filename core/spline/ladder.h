// de Casteljau's ladder: between every two neighbours a new point, u of the way along, level after
// level, until one is left: the point of the curve at u (lecture, figure 5; de Casteljau 1959).
#pragma once

#include "core/spline/blend.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace splineloft {

/// Climbs one level in place: afterwards the first n - 1 of the n rungs are the next level.
template <Blendable T> void climb(std::span<T> rungs, double u) {
    for (std::size_t i = 0; i + 1 < rungs.size(); ++i) {
        rungs[i] = lerp(rungs[i], rungs[i + 1], u);
    }
}

/// The whole construction as a value: level 0 holds the Bézier points, level `degree` the tip.
template <Blendable T> class Ladder {
  public:
    Ladder(std::span<const T> bezierPoints, double u) {
        std::vector<T> rungs(bezierPoints.begin(), bezierPoints.end());
        while (!rungs.empty()) {
            levels_.push_back(rungs);
            climb(std::span(rungs), u);
            rungs.pop_back();
        }
    }

    /// The same levels, each point replaced by what `map` makes of it.
    template <class Map> Ladder mapped(Map map) const {
        Ladder result = *this;
        for (auto& level : result.levels_) {
            std::ranges::transform(level, level.begin(), map);
        }
        return result;
    }

    /// The degree of the curve: one less than the number of levels.
    int degree() const { return static_cast<int>(levels_.size()) - 1; }
    /// Level r has degree + 1 - r points.
    std::span<const T> level(int r) const { return levels_[static_cast<std::size_t>(r)]; }
    /// The point of the curve.
    const T& tip() const { return levels_.back().front(); }

  private:
    std::vector<std::vector<T>> levels_;
};

} // namespace splineloft
