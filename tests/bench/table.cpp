#include "tests/bench/table.h"

#include "tests/bench/figures.h"

namespace splineloft::bench {
namespace {

/// The row and program by which machines are compared, and its ns a point where the goals and
/// kurbo's times were measured (two Zen 3 cores at 3.1 GHz).
constexpr std::pair<std::string_view, std::string_view> paceMaker = {"dense-2d", "glm"};
constexpr double paceMakerThere = 3.5;
constexpr std::string_view kurboName = "kurbo";

std::optional<double> paceOf(const Measurements& measurements) {
    const auto found = measurements.find(paceMaker);
    return found == measurements.end() ? std::nullopt
                                       : std::optional(found->second.nanoseconds / paceMakerThere);
}

Competitor competitorOf(const Contest& contest, const Measurements& measurements,
                        std::string_view row, std::string_view program) {
    if (const auto found = measurements.find({row, program}); found != measurements.end()) {
        return {program, Presence::measured, found->second};
    }
    const bool entered = std::ranges::any_of(contest.entries, [&](const Entry& entry) {
        return entry.row == row && entry.program == program;
    });
    return {program, entered ? Presence::notRun : Presence::notInstalled, {}};
}

bool wasRun(const Measurements& measurements, const Row& row) {
    return std::ranges::any_of(measurements,
                               [&row](const auto& entry) { return entry.first.first == row.id; });
}

bool hasTime(const Competitor& competitor) {
    return competitor.presence == Presence::measured || competitor.presence == Presence::estimated;
}

std::vector<Competitor> peersOf(const Contest& contest, const Measurements& measurements,
                                const Row& row, std::optional<double> pace) {
    std::vector<Competitor> peers;
    for (const auto& program : row.peers) {
        peers.push_back(competitorOf(contest, measurements, row.id, program));
    }
    if (row.kurbo > 0) {
        peers.push_back({kurboName,
                         pace ? Presence::estimated : Presence::notRun,
                         {row.kurbo * pace.value_or(0), 0}});
    }
    std::ranges::stable_sort(peers, {}, [](const Competitor& peer) {
        return hasTime(peer) ? peer.measurement.nanoseconds
                             : std::numeric_limits<double>::infinity();
    });
    return peers;
}

/// How many times the time that we take a peer takes.
std::optional<double> timesAsFast(const Line& line, std::string_view peer) {
    for (const auto& candidate : line.peers) {
        if (candidate.program == peer && hasTime(candidate) && hasTime(line.ours)) {
            return candidate.measurement.nanoseconds / line.ours.measurement.nanoseconds;
        }
    }
    return std::nullopt;
}

std::string times(double factor) {
    return figure(factor) + "x";
}

Outcome outcomeOf(const TimesAsFastAs& goal, const Line& line, std::optional<double>) {
    Outcome outcome{">= " + shortest(goal.factor) + "x " + std::string(goal.peer), "", {}};
    if (const auto reached = timesAsFast(line, goal.peer)) {
        outcome.reached = times(*reached);
        outcome.met = *reached >= goal.factor;
    }
    return outcome;
}

Outcome outcomeOf(const TimesTheTimeOf& goal, const Line& line, std::optional<double>) {
    Outcome outcome{"<= " + shortest(goal.factor) + "x " + std::string(goal.peer), "", {}};
    if (const auto reached = timesAsFast(line, goal.peer)) {
        outcome.reached = times(1 / *reached);
        outcome.met = 1 / *reached <= goal.factor;
    }
    return outcome;
}

Outcome outcomeOf(const AtMost& goal, const Line& line, std::optional<double> pace) {
    Outcome outcome{"<= " + shortest(goal.nanoseconds) + " ns there", "", {}};
    if (pace && hasTime(line.ours)) {
        const double there = line.ours.measurement.nanoseconds / *pace;
        outcome.reached = figure(there);
        outcome.met = there <= goal.nanoseconds;
    }
    return outcome;
}

Outcome outcomeOf(const ErrorAtMost& goal, const Line& line, std::optional<double>) {
    Outcome outcome{"error <= " + power(goal.error), "", {}};
    if (hasTime(line.ours)) {
        outcome.reached = power(line.ours.measurement.error);
        outcome.met = line.ours.measurement.error <= goal.error;
    }
    return outcome;
}

} // namespace

Table tableOf(const Contest& contest, const Measurements& measurements) {
    Table table{.lines = {}, .pace = paceOf(measurements)};
    for (const auto& row : contest.rows) {
        if (!wasRun(measurements, row)) {
            continue;
        }
        Line line{.row = row,
                  .ours = competitorOf(contest, measurements, row.id, ourName),
                  .peers = peersOf(contest, measurements, row, table.pace),
                  .timesFastest = {},
                  .outcomes = {}};
        if (!line.peers.empty()) {
            line.timesFastest = timesAsFast(line, line.peers.front().program);
        }
        for (const auto& goal : row.goals) {
            line.outcomes.push_back(std::visit(
                [&](const auto& kind) { return outcomeOf(kind, line, table.pace); }, goal));
        }
        table.lines.push_back(line);
    }
    return table;
}

} // namespace splineloft::bench
