// Single points here and there on a curve whose coefficients are kept.
#include "tests/bench/ours.h"
#include "tests/bench/reference.h"
#include "tests/bench/rows.h"
#include "tests/bench/works.h"

namespace splineloft::bench {
namespace {

constexpr std::size_t spotCount = 8192;

RandomSpots makeRandomSpots() {
    const auto& curve = uniformCubic();
    RandomSpots work;
    Dice dice(3);
    for (std::size_t i = 0; i < spotCount; ++i) {
        const double t = dice.between(0, static_cast<double>(curve.pieces));
        const auto piece = static_cast<std::size_t>(t);
        const auto u = static_cast<long double>(t) - static_cast<long double>(piece);
        work.t.push_back(t);
        for (std::size_t c = 0; c < 2; ++c) {
            work.positions.push_back(catmullRom(&curve.points[2 * piece + c], 2, u).value);
        }
    }
    return work;
}

Trial ourRandom() {
    const auto& work = randomSpots();
    const auto positionsAt = ours::positionsAt(ours::catmullRom(uniformCubic().points, 2));
    return filling<double>(
        work.positions, [positionsAt, &work](std::span<double> out) { positionsAt(work.t, out); });
}

} // namespace

const RandomSpots& randomSpots() {
    static const auto work = makeRandomSpots();
    return work;
}

void addRandom(Contest& contest) {
    contest.rows.push_back({.id = "random-2d",
                            .work = "same, 2-D double, at random t",
                            .items = spotCount,
                            .peers = {"glm", "Eigen", "Boost"},
                            .goals = {TimesAsFastAs{"glm", 1.7}}});
    contest.entries.push_back({"random-2d", ourName, ourRandom});
}

} // namespace splineloft::bench
