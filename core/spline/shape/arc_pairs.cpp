#include "core/spline/shape/arc_pairs.h"

#include <algorithm>
#include <bit>
#include <limits>

namespace splineloft {

ArcPairs::ArcPairs(std::span<const Arc> arcs) : leaves_(std::bit_ceil(arcs.size())) {
    constexpr double beyond = std::numeric_limits<double>::infinity();
    boxes_.assign(2 * leaves_, {{beyond, beyond}, {-beyond, -beyond}});
    for (std::size_t i = 0; i < arcs.size(); ++i) {
        Box& box = boxes_[leaves_ + i];
        for (std::size_t c = 0; c < 2; ++c) {
            box.least[c] = arcs[i].least[c] - arcs[i].rounding;
            box.greatest[c] = arcs[i].greatest[c] + arcs[i].rounding;
        }
    }
    for (std::size_t k = leaves_; k-- > 1;) {
        for (std::size_t c = 0; c < 2; ++c) {
            boxes_[k].least[c] = std::min(boxes_[2 * k].least[c], boxes_[2 * k + 1].least[c]);
            boxes_[k].greatest[c] =
                std::max(boxes_[2 * k].greatest[c], boxes_[2 * k + 1].greatest[c]);
        }
    }
    toCompare_.push_back({1, 1});
}

std::optional<ArcPair> ArcPairs::next(std::int64_t& work) {
    while (!toCompare_.empty() && work > 0) {
        const auto [a, b] = toCompare_.back();
        toCompare_.pop_back();
        --work;
        if (!overlap(boxes_[a], boxes_[b])) {
            continue;
        }
        if (a < leaves_) {
            toCompare_.push_back({2 * a + 1, 2 * b + 1});
            toCompare_.push_back({2 * a, 2 * b + 1});
            if (a != b) {
                toCompare_.push_back({2 * a + 1, 2 * b});
            }
            toCompare_.push_back({2 * a, 2 * b});
        } else if (a != b) {
            return ArcPair{a - leaves_, b - leaves_};
        }
    }
    return std::nullopt;
}

bool ArcPairs::overlap(const Box& a, const Box& b) {
    return a.least[0] <= b.greatest[0] && b.least[0] <= a.greatest[0] &&
           a.least[1] <= b.greatest[1] && b.least[1] <= a.greatest[1];
}

} // namespace splineloft
