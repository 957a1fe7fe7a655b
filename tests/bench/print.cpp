// The table as text, as Markdown and as JSON.
#include "tests/bench/figures.h"
#include "tests/bench/table.h"

#include <nlohmann/json.hpp>
#include <ostream>

namespace splineloft::bench {
namespace {

/// Widths of the columns; with a space between each two they make 120.
constexpr std::array<std::size_t, 6> widths = {38, 15, 27, 6, 22, 7};
using Cells = std::array<std::string, widths.size()>;

const Cells heads = {"work", "ours ns (error)", "peers ns (error)", "ratio", "goal: reached", ""};

std::string nameOf(Presence presence) {
    switch (presence) {
    case Presence::measured: return "measured";
    case Presence::estimated: return "estimated";
    case Presence::notRun: return "not run";
    case Presence::notInstalled: return "not installed";
    }
    return "";
}

std::string textOf(const Competitor& competitor) {
    switch (competitor.presence) {
    case Presence::measured:
        return figure(competitor.measurement.nanoseconds) + " (" +
               power(competitor.measurement.error) + ")";
    case Presence::estimated: return figure(competitor.measurement.nanoseconds) + " *";
    case Presence::notRun: return "not run";
    case Presence::notInstalled:
        return competitor.program == ourName ? "not there" : "not installed";
    }
    return "";
}

std::string verdict(const Outcome& outcome) {
    return outcome.met ? (*outcome.met ? "met" : "NOT MET") : "unknown";
}

/// One line of text for every peer and every goal, whichever are more.
std::vector<Cells> rowsOf(const Line& line) {
    std::vector<Cells> rows(std::max({line.peers.size(), line.outcomes.size(), std::size_t{1}}));
    rows[0][0] = line.row.work;
    rows[0][1] = textOf(line.ours);
    for (std::size_t i = 0; i < line.peers.size(); ++i) {
        rows[i][2] = std::string(line.peers[i].program) + " " + textOf(line.peers[i]);
    }
    rows[0][3] = line.timesFastest ? figure(*line.timesFastest) : "";
    for (std::size_t i = 0; i < line.outcomes.size(); ++i) {
        const auto& outcome = line.outcomes[i];
        rows[i][4] = outcome.goal + (outcome.reached.empty() ? "" : ": " + outcome.reached);
        rows[i][5] = verdict(outcome);
    }
    return rows;
}

/// Characters, not bytes, of UTF-8.
std::size_t lengthOf(std::string_view text) {
    return static_cast<std::size_t>(
        std::ranges::count_if(text, [](char c) { return (c & 0xC0) != 0x80; }));
}

void printCells(std::ostream& out, const Cells& cells) {
    std::string text;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const auto length = lengthOf(cells[i]);
        text += cells[i] + std::string(widths[i] > length ? widths[i] - length : 0, ' ') + " ";
    }
    text.erase(text.find_last_not_of(' ') + 1);
    out << text << '\n';
}

void printNotes(std::ostream& out, const Table& table) {
    out << R"(Medians of CPU time on one thread of one process, in ns a point where nothing else is said. Curves are
made ready beforehand; where building them is timed too, the row says so, as do length and even points.
error: the largest deviation from a long double reference, in units of its largest value (lengths: each
in units of its own; nearest: how much farther than the nearest). ratio: our speed over the fastest peer's.
SISL seeks the nearest spot locally (s1957) and may miss it; "SISL, all" (s1953) finds all that are near.
)";
    if (table.pace) {
        out << R"(* kurbo is estimated: it is Rust, and not in Debian. Its times on the machine of the goals are carried
over by those of GLM, which takes )"
            << figure(*table.pace)
            << R"( of its time there. "ns there" is our time carried back likewise.)" << '\n';
    }
}

nlohmann::ordered_json jsonOf(const Competitor& competitor) {
    nlohmann::ordered_json json = {{"program", competitor.program},
                                   {"presence", nameOf(competitor.presence)}};
    if (competitor.presence == Presence::measured || competitor.presence == Presence::estimated) {
        json["nanoseconds"] = competitor.measurement.nanoseconds;
    }
    if (competitor.presence == Presence::measured) {
        json["error"] = competitor.measurement.error;
    }
    return json;
}

nlohmann::ordered_json jsonOf(const Line& line) {
    nlohmann::ordered_json json = {
        {"id", line.row.id}, {"work", line.row.work}, {"ours", jsonOf(line.ours)}};
    json["peers"] = nlohmann::ordered_json::array();
    for (const auto& peer : line.peers) {
        json["peers"].push_back(jsonOf(peer));
    }
    if (line.timesFastest) {
        json["timesFastestPeer"] = *line.timesFastest;
    }
    json["goals"] = nlohmann::ordered_json::array();
    for (const auto& outcome : line.outcomes) {
        json["goals"].push_back(
            {{"goal", outcome.goal}, {"reached", outcome.reached}, {"verdict", verdict(outcome)}});
    }
    return json;
}

} // namespace

void print(std::ostream& out, const Table& table) {
    printCells(out, heads);
    Cells rule;
    std::ranges::transform(widths, rule.begin(),
                           [](auto width) { return std::string(width, '-'); });
    printCells(out, rule);
    for (const auto& line : table.lines) {
        for (const auto& cells : rowsOf(line)) {
            printCells(out, cells);
        }
    }
    out << '\n';
    printNotes(out, table);
}

void printMarkdown(std::ostream& out, const Table& table) {
    const auto printRow = [&out](const Cells& cells) {
        for (const auto& cell : cells) {
            out << "| " << cell << ' ';
        }
        out << "|\n";
    };
    printRow(heads);
    out << "|---|---|---|---|---|---|\n";
    for (const auto& line : table.lines) {
        std::ranges::for_each(rowsOf(line), printRow);
    }
    out << '\n';
    printNotes(out, table);
}

void printJson(std::ostream& out, const Table& table) {
    nlohmann::ordered_json json;
    if (table.pace) {
        json["pace"] = *table.pace;
    }
    json["rows"] = nlohmann::ordered_json::array();
    for (const auto& line : table.lines) {
        json["rows"].push_back(jsonOf(line));
    }
    out << json.dump(2) << '\n';
}

} // namespace splineloft::bench
