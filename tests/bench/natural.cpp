// The natural spline of y over x: to build it, and to evaluate it at random x.
#include "tests/bench/ours.h"
#include "tests/bench/reference.h"
#include "tests/bench/rows.h"
#include "tests/bench/works.h"

namespace splineloft::bench {
namespace {

constexpr std::size_t smallSize = 10'000;
constexpr std::size_t largeSize = 1'000'000;
constexpr std::size_t askedCount = 8192;

/// `leastStep` = 1 makes even steps of 1, less makes steps from it to 2 - it.
Graph makeGraph(std::size_t size, double leastStep) {
    Graph work;
    Dice dice(5);
    double x = 0;
    for (std::size_t i = 0; i < size; ++i) {
        work.x.push_back(x);
        work.y.push_back(dice.between(-1, 1));
        x += dice.between(leastStep, 2 - leastStep);
    }
    const NaturalReference right(work.x, work.y);
    for (std::size_t i = 0; i < askedCount; ++i) {
        work.asked.push_back(dice.between(0, work.x.back()));
        work.answers.push_back(right.at(work.asked.back()));
    }
    work.step = leastStep < 1 ? 0 : 1;
    work.slopeAtStart = static_cast<double>(right.slopeAtStart());
    work.slopeAtEnd = static_cast<double>(right.slopeAtEnd());
    return work;
}

constexpr double unevenStep = 0.5;

Trial ourBuild(const Graph& work) {
    const auto build = ours::naturalBuild(work.x, work.y);
    return {.pass =
                [build] {
                    build.run();
                    benchmark::ClobberMemory();
                },
            .error =
                [build, &work] {
                    std::vector<double> found(askedOfBuilt);
                    build.at(std::span(work.asked).first(askedOfBuilt), found);
                    return deviation<double>(found, std::span(work.answers).first(askedOfBuilt));
                }};
}

Trial ourEvaluation(const Graph& work) {
    const auto build = ours::naturalBuild(work.x, work.y);
    return filling<double>(work.answers,
                           [build, &work](std::span<double> out) { build.at(work.asked, out); });
}

void addRows(Contest& contest) {
    contest.rows.push_back({.id = "natural-build-1e4",
                            .work = "natural spline, build 10^4 (a point)",
                            .items = smallSize,
                            .peers = {"GSL"},
                            .goals = {TimesAsFastAs{"GSL", 6}}});
    contest.rows.push_back({.id = "natural-build-1e6",
                            .work = "same, 10^6",
                            .items = largeSize,
                            .peers = {"GSL"},
                            .goals = {TimesAsFastAs{"GSL", 6}}});
    contest.rows.push_back({.id = "natural-build-even",
                            .work = "same, 10^4, x in equal steps",
                            .items = smallSize,
                            .peers = {"GSL", "Boost"}});
    contest.rows.push_back({.id = "natural-at",
                            .work = "natural spline of 10^4, at random x",
                            .items = askedCount,
                            .peers = {"GSL"},
                            .goals = {TimesAsFastAs{"GSL", 5}}});
    contest.rows.push_back({.id = "natural-at-even",
                            .work = "same, x in equal steps",
                            .items = askedCount,
                            .peers = {"GSL", "Boost"}});
}

} // namespace

const Graph& smallGraph() {
    static const auto work = makeGraph(smallSize, unevenStep);
    return work;
}

const Graph& largeGraph() {
    static const auto work = makeGraph(largeSize, unevenStep);
    return work;
}

const Graph& smallEvenGraph() {
    static const auto work = makeGraph(smallSize, 1);
    return work;
}

void addNatural(Contest& contest) {
    addRows(contest);
    contest.entries.insert(
        contest.entries.end(),
        {{"natural-build-1e4", ourName, [] { return ourBuild(smallGraph()); }},
         {"natural-build-1e6", ourName, [] { return ourBuild(largeGraph()); }},
         {"natural-build-even", ourName, [] { return ourBuild(smallEvenGraph()); }},
         {"natural-at", ourName, [] { return ourEvaluation(smallGraph()); }},
         {"natural-at-even", ourName, [] { return ourEvaluation(smallEvenGraph()); }}});
}

} // namespace splineloft::bench
