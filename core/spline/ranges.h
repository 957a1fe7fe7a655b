// Runs of neighbours in a sequence (points, pieces), and which of them differ from what they were.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace splineloft {

/// The members [first, last) of a sequence.
struct Range {
    std::size_t first = 0, last = 0;
    std::size_t size() const { return last - first; }
    bool operator==(const Range&) const = default;
};

/// Some ranges in order, none touching the next, with the same members as `ranges`, which may be in
/// any order and overlap.
std::vector<Range> merged(std::vector<Range> ranges);

/// The rows of `width` numbers that are not the same, bit for bit, in two tables of the same size.
/// In order, none touching the next. As quick as comparing memory where most are the same.
std::vector<Range> changedRows(std::span<const double> before, std::span<const double> after,
                               std::size_t width = 1);

} // namespace splineloft
