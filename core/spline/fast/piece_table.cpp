#include "core/spline/fast/piece_table.h"

#include <algorithm>
#include <array>

namespace splineloft {
namespace {

// Of so many buckets beside each other, the entries are written at once.
constexpr std::size_t ahead = 4;

// So many points are entered at once, and so many before them are known by their buckets.
constexpr std::size_t some = 1024;
constexpr std::size_t known = 63;

using Numbers = std::array<std::uint32_t, known + some>;

/// Whether any of the numbers from `begin` on is more than `ahead` above the one before.
bool hasGaps(const Numbers& numbers, std::size_t begin, std::size_t end) {
    std::uint32_t wide = 0;
    for (std::size_t k = begin; k < end; ++k) {
        wide |= numbers[k] - numbers[k - 1] > ahead ? 1 : 0;
    }
    return wide != 0;
}

/// Whether any of the numbers from `begin` on is that of `distance` places before.
bool repeats(const Numbers& numbers, std::size_t begin, std::size_t end, std::size_t distance) {
    std::uint32_t same = 0;
    for (std::size_t k = std::max(begin, distance); k < end; ++k) {
        same |= numbers[k] == numbers[k - distance] ? 1 : 0;
    }
    return same != 0;
}

} // namespace

void PieceTable::begin(std::size_t pieces, double start, double end) {
    pieces_ = pieces;
    buckets_ = {start, static_cast<double>(pieces) / (end - start)};
    lastBefore_.resize(pieces + 2 + ahead); // the end may be rounded up into another bucket
    std::fill_n(lastBefore_.begin(), ahead + 1, 0);
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

/// Behind the bucket of each point, entries get its number, up to the bucket of the next one.
void PieceTable::enterSome(const double* x, std::size_t first, std::size_t last) {
    const std::size_t before = std::min(first, known);
    const std::size_t all = before + last - first;
    Numbers numbers;
    lanes::findBuckets(buckets_, x + first - before, all, numbers.data());
    auto* const table = lastBefore_.data();
    auto point = static_cast<std::uint32_t>(first);
    const bool gaps = hasGaps(numbers, before, all);
    for (std::size_t k = before; k < all; ++k, ++point) {
        const std::size_t bucket = numbers[k];
        if (gaps && bucket > numbers[k - 1] + ahead) {
            std::fill(table + numbers[k - 1] + ahead + 1, table + bucket + 1, point - 1);
        }
        std::fill_n(table + bucket + 1, ahead, point);
    }
    const auto isFuller = [&](std::size_t distance) {
        if (distance <= known) {
            return repeats(numbers, before, all, distance);
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
