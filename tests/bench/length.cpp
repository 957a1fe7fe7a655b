// The length of single cubics, among them some that all but stop on their way.
#include "tests/bench/ours.h"
#include "tests/bench/reference.h"
#include "tests/bench/rows.h"
#include "tests/bench/works.h"

namespace splineloft::bench {
namespace {

constexpr std::size_t numbersACubic = 8;

RandomCubics makeRandomCubics() {
    RandomCubics work;
    work.bezier = Dice(6).between(work.count * numbersACubic, -4, 4);
    for (std::size_t i = 0; i < work.count; ++i) {
        work.lengths.push_back(cubicLength(&work.bezier[i * numbersACubic]));
    }
    return work;
}

Trial ourLength() {
    const auto& work = randomCubics();
    std::vector<Pieces> cubics;
    for (std::size_t i = 0; i < work.count; ++i) {
        cubics.push_back(
            ours::bezierSpline(std::span(work.bezier).subspan(i * numbersACubic, numbersACubic)));
    }
    const auto lengths = std::make_shared<std::vector<double>>(work.count);
    return {.pass =
                [cubics, lengths] {
                    for (std::size_t i = 0; i < cubics.size(); ++i) {
                        (*lengths)[i] = ours::length(cubics[i]);
                    }
                    benchmark::ClobberMemory();
                },
            .error = [lengths] { return deviationOfLengths(*lengths); }};
}

} // namespace

const RandomCubics& randomCubics() {
    static const auto work = makeRandomCubics();
    return work;
}

double deviationOfLengths(const std::vector<double>& lengths) {
    const auto& right = randomCubics().lengths;
    double worst = 0;
    for (std::size_t i = 0; i < right.size(); ++i) {
        worst = std::max(worst, deviation<double>(std::span(lengths).subspan(i, 1),
                                                  std::span(right).subspan(i, 1)));
    }
    return worst;
}

void addLength(Contest& contest) {
    contest.rows.push_back({.id = "length",
                            .work = "length of a cubic to 1e-9 (a curve)",
                            .items = randomCubics().count,
                            .peers = {"GSL", "lib2geom"},
                            .goals = {AtMost{300}, ErrorAtMost{1e-9}},
                            .kurbo = 248});
    contest.entries.push_back({"length", ourName, ourLength});
}

} // namespace splineloft::bench
