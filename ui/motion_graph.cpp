#include "ui/motion_graph.h"

#include "ui/extremes.h"

#include <algorithm>
#include <cmath>

namespace splineloft::ui {
namespace {

constexpr std::size_t columnsToTellPieces = 4; // a piece needs so many on average
constexpr std::size_t fewestInside = 6;        // samples between the ends of a piece

/// The samples of one piece at its ends and at times between, of which it gets the spots.
MotionRun runOn(const Motion& motion, std::size_t segment, std::span<const Spot> inside) {
    MotionRun run;
    const auto take = [&](Spot spot) {
        run.push_back({spot, motion.timeAt(spot), motion.at(spot)});
    };
    take({segment, 0});
    for (const auto& spot : inside) {
        // Rounding may put the first or the last of them onto a neighbour.
        if (spot.segment == segment) {
            take(spot);
        }
    }
    take({segment, 1});
    return run;
}

/// A piece that takes time, and how many samples it gets between its ends.
struct Share {
    std::size_t segment, inside;
};

} // namespace

std::optional<double> valueOf(const Movement& moment, Quantity quantity) {
    switch (quantity) {
    case Quantity::speed: return moment.speed;
    case Quantity::acceleration: return moment.acceleration;
    case Quantity::curvature: return moment.curvature;
    }
    return std::nullopt;
}

MotionGraph::MotionGraph(const Pieces& pieces, const Motion& motion, std::size_t columns) {
    columns = std::max<std::size_t>(columns, 1);
    if (pieces.empty()) {
        return;
    }
    if (columnsToTellPieces * pieces.size() <= std::max<std::size_t>(columns, 64)) {
        sampleEachPiece(pieces, motion, columns);
    } else {
        sampleWhole(motion, columns);
    }
    for (const auto quantity : allQuantities) {
        of_[static_cast<std::size_t>(quantity)] = summaryOf(quantity, motion);
    }
}

void MotionGraph::sampleEachPiece(const Pieces& pieces, const Motion& motion, std::size_t columns) {
    std::vector<Share> shares;
    std::vector<double> times; // those inside of the pieces, in order
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const double start = motion.timeAt({i, 0}), end = motion.timeAt({i, 1});
        if (!(start < end)) {
            continue; // passed in no time
        }
        if (!shares.empty()) {
            joints_.push_back(start);
        }
        const double part = (end - start) / motion.duration();
        const auto inside =
            fewestInside + static_cast<std::size_t>(2 * part * static_cast<double>(columns));
        shares.push_back({i, inside});
        for (std::size_t k = 1; k <= inside; ++k) {
            times.push_back(
                std::lerp(start, end, static_cast<double>(k) / static_cast<double>(inside + 1)));
        }
    }
    const auto spots = motion.spotsAt(times);
    std::size_t first = 0;
    for (const auto& [segment, inside] : shares) {
        runs_.push_back(runOn(motion, segment, std::span(spots).subspan(first, inside)));
        first += inside;
    }
}

void MotionGraph::sampleWhole(const Motion& motion, std::size_t columns) {
    std::vector<double> times(3 * columns + 1);
    for (std::size_t k = 0; k < times.size(); ++k) {
        times[k] =
            motion.duration() * static_cast<double>(k) / static_cast<double>(times.size() - 1);
    }
    const auto spots = motion.spotsAt(times);
    MotionRun run;
    for (std::size_t k = 0; k < times.size(); ++k) {
        run.push_back({spots[k], times[k], motion.at(spots[k])});
    }
    runs_.push_back(std::move(run));
}

MotionGraph::Summary MotionGraph::summaryOf(Quantity quantity, const Motion& motion) const {
    return {extremesOf(runs_, quantity, motion), rangeOf(runs_, quantity, motion.duration())};
}

} // namespace splineloft::ui
