// The table after the run: each row with our time and error, those of the peers, and whether the
// goals are met.
#pragma once

#include "tests/bench/contest.h"

#include <iosfwd>
#include <map>
#include <optional>
#include <string>
#include <utility>

namespace splineloft::bench {

/// What was measured of one program in one row.
struct Measurement {
    double nanoseconds = 0; ///< per point, curve or query; the median of the repetitions
    double error = 0;
};

/// By row and program.
using Measurements = std::map<std::pair<std::string_view, std::string_view>, Measurement>;

/// Why a program has no figures, or that it has.
enum class Presence { measured, estimated, notRun, notInstalled };

struct Competitor {
    std::string_view program;
    Presence presence = Presence::notInstalled;
    Measurement measurement; ///< an estimate has no error
};

/// A goal in words, what we reach of it in words, and whether that is enough, where it is known.
struct Outcome {
    std::string goal;
    std::string reached;
    std::optional<bool> met;
};

struct Line {
    Row row;
    Competitor ours;
    std::vector<Competitor> peers;      ///< fastest first
    std::optional<double> timesFastest; ///< how many times as fast as the fastest peer we are
    std::vector<Outcome> outcomes;
};

struct Table {
    std::vector<Line> lines;
    /// How much slower than the machine on which the goals were measured this one is, by GLM.
    std::optional<double> pace;
};

/// The rows of which anything was run.
Table tableOf(const Contest& contest, const Measurements& measurements);

/// For people, 120 columns wide.
void print(std::ostream& out, const Table& table);
void printMarkdown(std::ostream& out, const Table& table);
void printJson(std::ostream& out, const Table& table);

} // namespace splineloft::bench
