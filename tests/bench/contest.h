// A contest: the rows of the table of performance goals, and the programs that compete in each.
//
// A row says what is to be done and what we aim at. An entry is one program's way of doing it, with
// the inputs that all others get. A peer that is not installed simply has no entry.
#pragma once

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <span>
#include <string_view>
#include <variant>
#include <vector>

namespace splineloft::bench {

/// The name under which our own entries compete.
inline constexpr std::string_view ourName = "ours";

/// A program that is ready to begin.
struct Trial {
    std::function<void()> pass;    ///< does the whole work of the row once
    std::function<double()> error; ///< of the last pass: relative, against the reference
};

/// One program in one row.
struct Entry {
    std::string_view row;     ///< its id
    std::string_view program; ///< `ourName`, or a peer
    std::function<Trial()> prepare;
};

/// To be `factor` times as fast as a peer, in the same run.
struct TimesAsFastAs {
    std::string_view peer;
    double factor;
};
/// To take no more than `factor` times the time of a peer.
struct TimesTheTimeOf {
    std::string_view peer;
    double factor;
};
/// Nanoseconds on the machine of the goals, carried over to this one by its pace.
struct AtMost {
    double nanoseconds;
};
/// To miss the reference by no more than this.
struct ErrorAtMost {
    double error;
};
using Goal = std::variant<TimesAsFastAs, TimesTheTimeOf, AtMost, ErrorAtMost>;

/// One row of the table.
struct Row {
    std::string_view id;   ///< as in the names of the benchmarks
    std::string_view work; ///< for people; at most 38 characters
    std::size_t items = 1; ///< points, curves or queries of one pass
    std::vector<std::string_view> peers = {};
    std::vector<Goal> goals = {};
    double kurbo = 0; ///< ns an item where the goals were measured; 0 where kurbo takes no part
};

/// Everything that is measured.
struct Contest {
    std::vector<Row> rows;
    std::vector<Entry> entries;
};

/// All rows and all entries of what is installed.
Contest wholeContest();

/// Largest deviation from the reference, in units of the reference's largest value. Infinite where
/// something is missing or not a number. What is found beyond the reference is not looked at.
template <class Number>
double deviation(std::span<const Number> found, std::span<const long double> reference) {
    long double worst = 0;
    long double size = 0;
    for (std::size_t i = 0; i < reference.size(); ++i) {
        const bool there = i < found.size() && std::isfinite(found[i]);
        const auto off = there ? std::abs(static_cast<long double>(found[i]) - reference[i])
                               : std::numeric_limits<long double>::infinity();
        worst = std::max(worst, off);
        size = std::max(size, std::abs(reference[i]));
    }
    return static_cast<double>(worst / size);
}

/// The usual trial: `fill` writes numbers, which are then compared with the reference. The
/// reference must outlive the trial. `more` is how many numbers are written beyond it.
template <class Number, class Fill>
Trial filling(const std::vector<long double>& reference, Fill fill, std::size_t more = 0) {
    const auto numbers = std::make_shared<std::vector<Number>>(
        reference.size() + more, std::numeric_limits<Number>::quiet_NaN());
    return {.pass =
                [numbers, fill] {
                    fill(std::span<Number>(*numbers));
                    benchmark::DoNotOptimize(numbers->data());
                    benchmark::ClobberMemory();
                },
            .error = [numbers, &reference] { return deviation<Number>(*numbers, reference); }};
}

} // namespace splineloft::bench
