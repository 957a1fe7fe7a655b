#include "core/spline/fast/piece_table.h"

#include "core/spline/fast/lanes/bucket_lanes.h"

#include <algorithm>
#include <array>

namespace splineloft {
namespace {

// So many points are entered at once, and so many before them are known by their buckets.
constexpr std::size_t some = 1024;
constexpr std::size_t known = 63;

} // namespace

void PieceTable::begin(std::size_t pieces, double start, double end) {
    pieces_ = pieces;
    buckets_ = {start, static_cast<double>(pieces) / (end - start)};
    lastBefore_.resize(pieces + 2 +
                       lanes::bucketsAhead); // the end may be rounded up into another bucket
    std::fill_n(lastBefore_.begin(), lanes::bucketsAhead + 1, 0);
    firstStep_ = pieces > 1 ? 1 : 0;
}

void PieceTable::enter(const double* x, std::size_t first, std::size_t last) {
    const std::size_t end = std::min(last, pieces_);
    for (std::size_t i = std::max<std::size_t>(first, 1); i < end; i += some) {
        enterSome(x, i, std::min(i + some, end));
    }
    if (last > pieces_) {
        const auto next = static_cast<std::ptrdiff_t>(buckets_.of(x[pieces_ - 1]) + 1);
        std::fill(lastBefore_.begin() + next, lastBefore_.end(),
                  static_cast<std::uint32_t>(pieces_ - 1));
    }
}

void PieceTable::enterSome(const double* x, std::size_t first, std::size_t last) {
    const std::size_t before = std::min(first, known);
    const std::size_t all = before + last - first;
    std::array<std::uint32_t, known + some> numbers;
    lanes::findBuckets(buckets_, x + first - before, all, numbers.data());
    lanes::enterBuckets(&numbers[before], last - first, static_cast<std::uint32_t>(first),
                        lastBefore_.data());
    const auto isFuller = [&](std::size_t distance) {
        if (distance <= known) {
            const std::size_t begin = std::max(before, distance);
            return begin < all && lanes::repeats(&numbers[begin], all - begin, distance);
        }
        for (std::size_t i = std::max(first, distance); i < last; ++i) {
            if (buckets_.of(x[i - distance]) == buckets_.of(x[i])) {
                return true;
            }
        }
        return false;
    };
    while (isFuller(2 * firstStep_ - 1)) {
        firstStep_ *= 2;
    }
}

} // namespace splineloft
