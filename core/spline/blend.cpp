#include "core/spline/blend.h"

#include <algorithm>

namespace splineloft {
namespace {

/// Merges two ordered lists of shares: a + sign * b. Shares that cancel exactly are dropped.
std::vector<Share> merge(std::span<const Share> a, std::span<const Share> b, double sign) {
    std::vector<Share> sum;
    sum.reserve(a.size() + b.size());
    auto left = a.begin();
    auto right = b.begin();
    while (left != a.end() || right != b.end()) {
        if (right == b.end() || (left != a.end() && left->control < right->control)) {
            sum.push_back(*left++);
        } else if (left == a.end() || right->control < left->control) {
            sum.push_back({right->control, sign * right->weight});
            ++right;
        } else {
            const double weight = left->weight + sign * right->weight;
            if (weight != 0) {
                sum.push_back({left->control, weight});
            }
            ++left;
            ++right;
        }
    }
    return sum;
}

} // namespace

Blend Blend::of(std::size_t control) {
    Blend blend;
    blend.shares_ = {{control, 1.0}};
    return blend;
}

double Blend::weight(std::size_t control) const {
    const auto found = std::ranges::lower_bound(shares_, control, {}, &Share::control);
    return found != shares_.end() && found->control == control ? found->weight : 0.0;
}

double Blend::sumBelow(std::size_t end) const {
    double sum = 0;
    for (const auto& share : shares_) {
        sum += share.control < end ? share.weight : 0.0;
    }
    return sum;
}

Blend operator+(const Blend& a, const Blend& b) {
    Blend sum;
    sum.shares_ = merge(a.shares_, b.shares_, 1);
    return sum;
}

Blend operator-(const Blend& a, const Blend& b) {
    Blend difference;
    difference.shares_ = merge(a.shares_, b.shares_, -1);
    return difference;
}

Blend operator*(double factor, const Blend& blend) {
    Blend scaled;
    if (factor != 0) {
        scaled.shares_ = blend.shares_;
        for (auto& share : scaled.shares_) {
            share.weight *= factor;
        }
    }
    return scaled;
}

Blend weightedSum(std::span<const double> weights, std::span<const Blend> blends) {
    std::vector<double> ofControls;
    for (std::size_t i = 0; i < blends.size(); ++i) {
        for (const auto& share : blends[i].shares()) {
            ofControls.resize(std::max(ofControls.size(), share.control + 1));
            ofControls[share.control] += weights[i] * share.weight;
        }
    }
    Blend sum;
    for (std::size_t control = 0; control < ofControls.size(); ++control) {
        if (ofControls[control] != 0) {
            sum.shares_.push_back({control, ofControls[control]});
        }
    }
    return sum;
}

} // namespace splineloft
