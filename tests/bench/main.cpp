// bench [--table=FILE.md|FILE.json] [--benchmark_...]: measures all rows of the contest in random
// order, several times each, and prints the table. The options of Google Benchmark work as usual,
// e.g. --benchmark_filter=dense or --benchmark_repetitions=21.
#include "tests/bench/table.h"

#include <fstream>
#include <iostream>

namespace splineloft::bench {
namespace {

/// Ours unless the caller says otherwise: the run then takes about two minutes.
constexpr std::array usualOptions = {"--benchmark_repetitions=9", "--benchmark_min_time=0.04",
                                     "--benchmark_enable_random_interleaving=true"};

/// One entry at work. It is prepared when its turn first comes, and kept for the repetitions.
class Runner {
  public:
    explicit Runner(Entry entry) : entry_(std::move(entry)) {}

    void operator()(benchmark::State& state) {
        if (!trial_) {
            trial_ = entry_.prepare();
            trial_->pass();
            error_ = trial_->error();
        }
        for ([[maybe_unused]] const auto& iteration : state) {
            trial_->pass();
        }
        state.counters["error"] = error_;
    }

  private:
    Entry entry_;
    std::optional<Trial> trial_;
    double error_ = 0;
};

/// Gathers what was measured; says nothing itself.
class Gatherer : public benchmark::BenchmarkReporter {
  public:
    explicit Gatherer(const Contest& contest) {
        for (const auto& entry : contest.entries) {
            runs_[nameOf(entry)];
        }
    }

    bool ReportContext(const Context&) override { return true; }

    void ReportRuns(const std::vector<Run>& report) override {
        for (const auto& run : report) {
            if (run.run_type == Run::RT_Iteration && !run.error_occurred) {
                auto& gathered = runs_[run.run_name.function_name];
                gathered.nanoseconds.push_back(run.GetAdjustedCPUTime());
                gathered.error = run.counters.at("error").value;
            }
        }
    }

    Measurements measurements(const Contest& contest) const {
        Measurements result;
        for (const auto& entry : contest.entries) {
            const auto& gathered = runs_.at(nameOf(entry));
            if (!gathered.nanoseconds.empty()) {
                const auto row = std::ranges::find(contest.rows, entry.row, &Row::id);
                result[{entry.row, entry.program}] = {
                    median(gathered.nanoseconds) / static_cast<double>(row->items), gathered.error};
            }
        }
        return result;
    }

    static std::string nameOf(const Entry& entry) {
        return std::string(entry.row) + "/" + std::string(entry.program);
    }

  private:
    struct Gathered {
        std::vector<double> nanoseconds; ///< of one pass, one a repetition
        double error = 0;
    };

    static double median(std::vector<double> values) {
        const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
        std::ranges::nth_element(values, middle);
        return *middle;
    }

    std::map<std::string, Gathered> runs_;
};

struct Options {
    std::string tableFile; ///< empty for none
    std::vector<std::string> forBenchmark;
};

Options optionsOf(int count, char** arguments) {
    constexpr std::string_view tableOption = "--table=";
    Options options;
    options.forBenchmark.emplace_back(arguments[0]);
    options.forBenchmark.insert(options.forBenchmark.end(), usualOptions.begin(),
                                usualOptions.end());
    for (int i = 1; i < count; ++i) {
        const std::string_view argument = arguments[i];
        if (argument.starts_with(tableOption)) {
            options.tableFile = argument.substr(tableOption.size());
        } else {
            options.forBenchmark.emplace_back(argument);
        }
    }
    return options;
}

/// False where an option is unknown, of which a message has then been printed.
bool initialize(Options& options) {
    std::vector<char*> arguments;
    for (auto& argument : options.forBenchmark) {
        arguments.push_back(argument.data());
    }
    auto count = static_cast<int>(arguments.size());
    benchmark::Initialize(&count, arguments.data());
    return !benchmark::ReportUnrecognizedArguments(count, arguments.data());
}

bool write(const std::string& file, const Table& table) {
    std::ofstream out(file);
    if (file.ends_with(".json")) {
        printJson(out, table);
    } else {
        printMarkdown(out, table);
    }
    return static_cast<bool>(out.flush());
}

int run(Options options) {
    if (!initialize(options)) {
        return 2;
    }
    const auto contest = wholeContest();
    for (const auto& entry : contest.entries) {
        const auto runner = std::make_shared<Runner>(entry);
        benchmark::RegisterBenchmark(Gatherer::nameOf(entry).c_str(),
                                     [runner](benchmark::State& state) { (*runner)(state); });
    }
    Gatherer gatherer(contest);
    std::cerr << "measuring; all of it takes about two minutes ...\n";
    benchmark::RunSpecifiedBenchmarks(&gatherer);
    const auto table = tableOf(contest, gatherer.measurements(contest));
    print(std::cout, table);
    if (!options.tableFile.empty() && !write(options.tableFile, table)) {
        std::cerr << "bench: cannot write " << options.tableFile << '\n';
        return 1;
    }
    return 0;
}

} // namespace
} // namespace splineloft::bench

int main(int count, char** arguments) {
    return splineloft::bench::run(splineloft::bench::optionsOf(count, arguments));
}
