// Point, first derivative and curvature together: combs, offsets, machining.
#include "tests/bench/ours.h"
#include "tests/bench/reference.h"
#include "tests/bench/rows.h"
#include "tests/bench/works.h"

#include <cmath>

namespace splineloft::bench {
namespace {

constexpr std::size_t numbersAJet = 5;

References makeJets() {
    const auto& work = uniformCubic();
    References jets;
    for (std::size_t piece = 0; piece < work.pieces; ++piece) {
        for (std::size_t k = 0; k < work.perPiece; ++k) {
            const auto u = static_cast<long double>(k) / static_cast<long double>(work.perPiece);
            const auto x = catmullRom(&work.points[2 * piece], 2, u);
            const auto y = catmullRom(&work.points[2 * piece + 1], 2, u);
            const auto speed = std::hypot(x.first, y.first);
            const auto cross = x.first * y.second - y.first * x.second;
            jets.insert(jets.end(),
                        {x.value, y.value, x.first, y.first, cross / (speed * speed * speed)});
        }
    }
    return jets;
}

Trial ourJets() {
    const auto& work = uniformCubic();
    const auto jets = ours::jets(ours::catmullRom(work.points, 2), work.perPiece);
    return {.pass =
                [jets] {
                    jets.run();
                    benchmark::ClobberMemory();
                },
            .error = [jets] { return deviationOfJets(jets.result()); }};
}

} // namespace

const References& uniformCubicJets() {
    static const auto jets = makeJets();
    return jets;
}

double deviationOfJets(const std::vector<double>& jets) {
    const auto& right = uniformCubicJets();
    double worst = 0;
    for (const auto& [first, count] : {std::pair{0, 2}, {2, 2}, {4, 1}}) {
        std::vector<double> found;
        References wanted;
        for (std::size_t i = 0; i < std::min(right.size(), jets.size()); ++i) {
            const auto which = static_cast<int>(i % numbersAJet);
            if (first <= which && which < first + count) {
                found.push_back(jets[i]);
                wanted.push_back(right[i]);
            }
        }
        worst = std::max(worst, deviation<double>(found, wanted));
    }
    return worst;
}

void addJets(Contest& contest) {
    contest.rows.push_back({.id = "jets",
                            .work = "point, derivative and curvature, 2-D",
                            .items = uniformCubicJets().size() / numbersAJet,
                            .peers = {"Eigen", "lib2geom"},
                            .goals = {TimesAsFastAs{"kurbo", 8}},
                            .kurbo = 22});
    contest.entries.push_back({"jets", ourName, ourJets});
}

} // namespace splineloft::bench
