#include "core/spline/ranges.h"

#include <algorithm>
#include <cstring>

namespace splineloft {
namespace {

// So many rows are compared at once before they are looked at one by one.
constexpr std::size_t rowsAtOnce = 64;

/// Adds a range that begins at or after the beginning of the last one.
void append(std::vector<Range>& ranges, Range next) {
    if (!ranges.empty() && next.first <= ranges.back().last) {
        ranges.back().last = std::max(ranges.back().last, next.last);
    } else {
        ranges.push_back(next);
    }
}

} // namespace

std::vector<Range> merged(std::vector<Range> ranges) {
    std::ranges::sort(ranges, {}, &Range::first);
    std::vector<Range> result;
    for (const auto& range : ranges) {
        if (range.size() > 0) {
            append(result, range);
        }
    }
    return result;
}

std::vector<Range> changedRows(std::span<const double> before, std::span<const double> after,
                               std::size_t width) {
    const auto same = [&](std::size_t first, std::size_t last) {
        return std::memcmp(before.data() + first * width, after.data() + first * width,
                           (last - first) * width * sizeof(double)) == 0;
    };
    std::vector<Range> changed;
    const auto rows = before.size() / width;
    for (std::size_t block = 0; block < rows; block += rowsAtOnce) {
        const auto end = std::min(block + rowsAtOnce, rows);
        if (same(block, end)) {
            continue;
        }
        for (auto row = block; row < end; ++row) {
            if (!same(row, row + 1)) {
                append(changed, {row, row + 1});
            }
        }
    }
    return changed;
}

} // namespace splineloft
