// What lies where along a sequence (points, pieces), without looking at every member: boxes around
// blocks of neighbours, boxes around sixteen of these, and so on up to one around everything.
#pragma once

#include "core/spline/ranges.h"
#include "ui/canvas/view.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <vector>

namespace splineloft::ui {

/// A rectangle on the plane of the canvas; empty to begin with.
struct PlaneBounds {
    double left = std::numeric_limits<double>::infinity();
    double bottom = std::numeric_limits<double>::infinity();
    double right = -std::numeric_limits<double>::infinity();
    double top = -std::numeric_limits<double>::infinity();

    bool operator==(const PlaneBounds&) const = default;
    bool empty() const { return !(left <= right && bottom <= top); }
    double size() const { return empty() ? 0 : std::max(right - left, top - bottom); }
    void include(PlanePoint p);
    void include(const PlaneBounds& box);
    bool touches(const PlaneBounds& other) const;
    /// How far a place is from it; 0 inside.
    double distanceTo(PlanePoint place) const;
};

/// The square of all places within `reach` across and up of one.
PlaneBounds around(PlanePoint place, double reach);

/// Boxes over a sequence of which one can ask for the box around a few members.
class BoxTree {
  public:
    static constexpr std::size_t blockSize = 64;

    /// Looks at all `count` members; `boxOf(Range)` is the box around some of them.
    template <class BoxOf> void build(std::size_t count, BoxOf boxOf) {
        count_ = count;
        levels_.clear();
        for (std::size_t boxes = blocks(); levels_.empty() || levels_.back().size() > 1;
             boxes = (boxes + fanOut - 1) / fanOut) {
            levels_.emplace_back(boxes);
        }
        update({0, count}, boxOf);
    }

    /// Looks again at the blocks in which some members are elsewhere than before.
    template <class BoxOf> void update(const Range& members, BoxOf boxOf) {
        if (members.size() == 0) {
            return;
        }
        Range changed{members.first / blockSize, (members.last - 1) / blockSize + 1};
        for (auto i = changed.first; i < changed.last; ++i) {
            levels_[0][i] = boxOf(block(i));
        }
        enclose(changed);
    }

    std::size_t count() const { return count_; }
    std::size_t blocks() const { return (count_ + blockSize - 1) / blockSize; }
    /// The members of a block.
    Range block(std::size_t index) const {
        return {index * blockSize, std::min(count_, (index + 1) * blockSize)};
    }
    const PlaneBounds& boxOfBlock(std::size_t index) const { return levels_[0][index]; }
    /// The box around everything.
    PlaneBounds whole() const { return count_ == 0 ? PlaneBounds() : levels_.back()[0]; }

    /// Calls `take(block)` for each block whose box touches `wanted`, in order.
    template <class Take> void touching(const PlaneBounds& wanted, Take take) const {
        if (count_ > 0) {
            descend(levels_.size() - 1, 0, wanted, take);
        }
    }

    /// Calls `look(block)` for the blocks that may hold what is nearest to `place`, the nearest
    /// boxes first. It returns the distance beyond which nothing is wanted any more; `within` is
    /// the first such distance.
    template <class Look> void nearestFirst(PlanePoint place, double within, Look look) const {
        if (count_ > 0) {
            approach(levels_.size() - 1, 0, place, within, look);
        }
    }

  private:
    static constexpr std::size_t fanOut = 16;

    void enclose(Range changed);

    Range childrenOf(std::size_t level, std::size_t index) const {
        return {index * fanOut, std::min(levels_[level - 1].size(), (index + 1) * fanOut)};
    }

    template <class Take>
    void descend(std::size_t level, std::size_t index, const PlaneBounds& wanted,
                 Take& take) const {
        if (!levels_[level][index].touches(wanted)) {
            return;
        }
        if (level == 0) {
            take(index);
            return;
        }
        const Range children = childrenOf(level, index);
        for (auto i = children.first; i < children.last; ++i) {
            descend(level - 1, i, wanted, take);
        }
    }

    template <class Look>
    void approach(std::size_t level, std::size_t index, PlanePoint place, double& within,
                  Look& look) const {
        if (level == 0) {
            within = look(index);
            return;
        }
        struct Child {
            double distance;
            std::size_t index;
        };
        std::array<Child, fanOut> near;
        std::size_t count = 0;
        const Range children = childrenOf(level, index);
        for (auto i = children.first; i < children.last; ++i) {
            near[count++] = {levels_[level - 1][i].distanceTo(place), i};
        }
        const auto end = near.begin() + static_cast<std::ptrdiff_t>(count);
        std::sort(near.begin(), end,
                  [](const Child& a, const Child& b) { return a.distance < b.distance; });
        for (auto child = near.begin(); child != end && child->distance <= within; ++child) {
            approach(level - 1, child->index, place, within, look);
        }
    }

    std::size_t count_ = 0;
    std::vector<std::vector<PlaneBounds>> levels_; // the blocks' first, one box of all last
};

} // namespace splineloft::ui
