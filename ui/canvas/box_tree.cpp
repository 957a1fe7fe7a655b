#include "ui/canvas/box_tree.h"

#include <cmath>

namespace splineloft::ui {

void PlaneBounds::include(PlanePoint p) {
    left = std::min(left, p.x);
    right = std::max(right, p.x);
    bottom = std::min(bottom, p.y);
    top = std::max(top, p.y);
}

void PlaneBounds::include(const PlaneBounds& box) {
    left = std::min(left, box.left);
    right = std::max(right, box.right);
    bottom = std::min(bottom, box.bottom);
    top = std::max(top, box.top);
}

bool PlaneBounds::touches(const PlaneBounds& other) const {
    return left <= other.right && right >= other.left && bottom <= other.top && top >= other.bottom;
}

double PlaneBounds::distanceTo(PlanePoint place) const {
    const double across = std::max({left - place.x, place.x - right, 0.0});
    const double up = std::max({bottom - place.y, place.y - top, 0.0});
    return std::hypot(across, up);
}

PlaneBounds around(PlanePoint place, double reach) {
    return {place.x - reach, place.y - reach, place.x + reach, place.y + reach};
}

void BoxTree::enclose(Range changed) {
    for (std::size_t level = 1; level < levels_.size(); ++level) {
        changed = {changed.first / fanOut, (changed.last - 1) / fanOut + 1};
        for (auto i = changed.first; i < changed.last; ++i) {
            PlaneBounds box;
            const Range children = childrenOf(level, i);
            for (auto child = children.first; child < children.last; ++child) {
                box.include(levels_[level - 1][child]);
            }
            levels_[level][i] = box;
        }
    }
}

} // namespace splineloft::ui
