#include "core/spline/fast/lanes/knot_finder.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace splineloft::lanes {

KnotFinder::KnotFinder(const KnotLine& knots)
    : knots_(knots.knots().begin(), knots.knots().end()), last_(knots.pieces() - 1) {
    while (last_ > 0 && knots.interval(last_) == 0) {
        --last_;
    }
    const double interval = knots.interval(0);
    evenKnots_ = {knots.start(), knots.end(), interval, 1 / interval, static_cast<double>(last_)};
    even_ = areEven();
    if (!even_) {
        fillBuckets();
    }
}

bool KnotFinder::areEven() const {
    for (std::size_t i = 0; i < knots_.size(); ++i) {
        // With and without rounding in between: what the compiler makes of it does not matter.
        const auto number = static_cast<double>(i);
        const double product = number * evenKnots_.interval;
        if (std::fma(number, evenKnots_.interval, knots_.front()) != knots_[i] ||
            knots_.front() + product != knots_[i]) {
            return false;
        }
    }
    return evenKnots_.interval > 0 && std::isfinite(evenKnots_.over);
}

/// Never falls as t rises, whatever the rounding.
std::size_t KnotFinder::bucketOf(double t) const {
    return std::min(static_cast<std::size_t>((t - knots_.front()) * bucketsPerT_),
                    before_.size() - 2);
}

void KnotFinder::fillBuckets() {
    constexpr std::size_t bucketsPerPiece = 2;
    const auto pieces = knots_.size() - 1;
    before_.assign(bucketsPerPiece * pieces + 1, 0);
    const double length = knots_.back() - knots_.front();
    const double ratio = static_cast<double>(before_.size() - 1) / length;
    bucketsPerT_ = std::isfinite(ratio) && std::isfinite(length) ? ratio : 0; // then one bucket
    for (std::size_t i = 0; i < pieces; ++i) {
        before_[bucketOf(knots_[i]) + 1] = static_cast<std::uint32_t>(i);
    }
    std::size_t fullest = 0;
    for (std::size_t b = 1; b < before_.size(); ++b) {
        before_[b] = std::max(before_[b], before_[b - 1]);
        fullest = std::max<std::size_t>(fullest, before_[b] - before_[b - 1]);
    }
    firstStep_ = std::bit_floor(fullest);
}

Spot KnotFinder::search(double t) const {
    if (!(t > knots_.front())) { // NaN as well
        t = knots_.front();
    }
    if (t >= knots_.back()) {
        return {last_, 1};
    }
    const auto bucket = bucketOf(t);
    std::size_t piece = before_[bucket];
    const std::size_t most = before_[bucket + 1];
    for (auto step = firstStep_; step > 0; step /= 2) {
        const auto next = std::min(piece + step, most);
        piece = knots_[next] <= t ? next : piece;
    }
    return {piece, (t - knots_[piece]) / (knots_[piece + 1] - knots_[piece])};
}

void KnotFinder::locate(const double* t, std::size_t count, std::int32_t* pieces, double* u) const {
    if (even_) {
        locateEvenly(evenKnots_, t, count, pieces, u);
        return;
    }
    for (std::size_t i = 0; i < count; ++i) {
        const auto spot = search(t[i]);
        pieces[i] = static_cast<std::int32_t>(spot.segment);
        u[i] = spot.u;
    }
}

} // namespace splineloft::lanes
