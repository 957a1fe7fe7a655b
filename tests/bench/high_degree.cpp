// A Bézier curve of high degree.
#include "tests/bench/ours.h"
#include "tests/bench/reference.h"
#include "tests/bench/rows.h"
#include "tests/bench/works.h"

namespace splineloft::bench {
namespace {

HighDegree makeHighDegree() {
    HighDegree work;
    work.bezier = Dice(4).between(2 * static_cast<std::size_t>(work.degree + 1), -4, 4);
    for (std::size_t k = 0; k < work.samples; ++k) {
        const auto u = static_cast<long double>(k) / static_cast<long double>(work.samples);
        for (std::size_t c = 0; c < 2; ++c) {
            work.positions.push_back(bezier(&work.bezier[c], 2, work.degree, u).value);
        }
    }
    return work;
}

Trial ourHighDegree() {
    const auto& work = highDegree();
    const auto pieces = ours::bezier(work.bezier);
    const auto more = ours::positionsSize(pieces, work.samples) - work.positions.size();
    return filling<double>(
        work.positions,
        [pieces, &work](std::span<double> out) { ours::positions(pieces, work.samples, out); },
        more);
}

} // namespace

const HighDegree& highDegree() {
    static const auto work = makeHighDegree();
    return work;
}

void addHighDegree(Contest& contest) {
    contest.rows.push_back({.id = "bezier-20",
                            .work = "Bézier of degree 20, 2-D double",
                            .items = highDegree().samples,
                            .peers = {"lib2geom", "Eigen"},
                            .goals = {TimesAsFastAs{"lib2geom", 20}}});
    contest.entries.push_back({"bezier-20", ourName, ourHighDegree});
}

} // namespace splineloft::bench
