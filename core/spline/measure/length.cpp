#include "core/spline/measure/length.h"

#include "core/spline/measure/length_walk.h"
#include "core/spline/measure/speed.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace splineloft {
namespace {

// What is left where the estimated error is below this part of the piece's size is rounding.
constexpr double fullPrecision = 1e-16;
// Spots found with a chart lie off by no more than this part of the whole length.
constexpr double chartError = 1e-15;
// No piece is cut into more panels than this.
constexpr std::size_t mostPanels = lanes::Panels::most;

/// It is known beforehand where the speed is smooth.
template <class Speed>
concept KnownSpeed = SpeedAlongPiece<Speed> && requires(const Speed& speed, lanes::Panels& panels) {
    speed.cut(1.0, lanes::Nodes::sixteen, panels);
    speed.integralOver(panels.all());
};

/// Cuts a piece into panels that are good to `tolerance`, and calls `take(start, end, length)` for
/// each, in order: as long ones as the speed allows, where that is known.
template <KnownSpeed Speed, class Take>
void forEachPanel(const Speed& speed, double tolerance, Take take) {
    lanes::Panels panels;
    speed.cut(tolerance, lanes::Nodes::sixteen, panels);
    for (std::size_t i = 0; i < panels.count; ++i) {
        const double start = panels.joints[i], end = panels.joints[i + 1];
        take(start, end, speed.unit() * integral(speed, start, end));
    }
}

/// Whether a panel of these samples is good to `tolerance`. Samples do not see a cusp between them:
/// that there is none, the hodograph's Bézier points have to say.
template <SpeedAlongPiece Speed>
bool isGood(const Speed& speed, double start, double end, const gauss::Samples& samples,
            double tolerance) {
    constexpr double steady = 0.1; // narrower dips than this leaves room for are seen
    const auto hull = speed.hullOn(start, end);
    if (hull.least < steady) {
        return (end - start) * hull.fastest <= tolerance; // hardly moves
    }
    return 0.5 * (end - start) * gauss::Spectrum(samples).error() <= tolerance;
}

/// Elsewhere, panels are halved until their samples show that they have converged.
template <SpeedAlongPiece Speed, class Take>
void forEachPanel(const Speed& speed, double tolerance, Take take) {
    std::array<double, Speed::mostHalvings> ends; // of the panels still to come, the next one last
    std::size_t waiting = 0;
    ends[waiting++] = speed.range().end;
    double start = speed.range().start;
    for (std::size_t cuts = 0; waiting > 0;) {
        const double end = ends[waiting - 1];
        const double middle = 0.5 * (start + end);
        const double half = 0.5 * (end - start);
        const auto samples = speed.on(middle, half);
        const bool isLast =
            cuts == mostPanels || waiting == ends.size() || !(start < middle && middle < end);
        if (isLast || isGood(speed, start, end, samples, tolerance)) {
            take(start, end, speed.unit() * (half * gauss::integralOf(samples)));
            start = end;
            --waiting;
        } else {
            ends[waiting++] = middle;
            ++cuts;
        }
    }
}

/// Sums of lengths stay finite.
double finite(double length) {
    return std::min(length, std::numeric_limits<double>::max());
}

/// The length of a piece alone needs no panels to come back to: a wider rule makes it of fewer.
template <KnownSpeed Speed> double lengthOfPiece(const Speed& speed, double tolerance) {
    lanes::Panels panels;
    speed.cut(tolerance, lanes::Nodes::thirtyTwo, panels);
    return speed.unit() * speed.integralOver(panels.all());
}

template <SpeedAlongPiece Speed> double lengthOfPiece(const Speed& speed, double tolerance) {
    double total = 0;
    forEachPanel(speed, tolerance,
                 [&](double, double, double length) { total = finite(total + length); });
    return total;
}

} // namespace

double lengthOf(const Pieces& pieces, double tolerance) {
    // Panels err by much less than their estimate. So many share the tolerance as a piece may need.
    constexpr double share = 1.0 / 2;
    const double each = tolerance > 0 ? share * tolerance / static_cast<double>(pieces.size()) : 0;
    double total = 0;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        withSpeeds(pieces[i], [&](const auto& speed) {
            total +=
                lengthOfPiece(speed, std::max(each / speed.unit(), fullPrecision * speed.size()));
            total = finite(total);
        });
    }
    return total;
}

ArcLength::ArcLength(const Pieces& pieces) : pieces_(&pieces) {
    panels_.reserve(4 * pieces.size());
    double total = 0;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        withSpeeds(pieces[i], [&](const auto& speed) {
            forEachPanel(speed, fullPrecision * speed.size(),
                         [&](double start, double end, double length) {
                             const double before = total;
                             total = finite(total + length);
                             panels_.push_back({i, start, end, before, total});
                         });
        });
    }
}

double ArcLength::upTo(Spot spot) const {
    const auto endsBefore = [](const Panel& panel, const Spot& s) {
        return panel.segment < s.segment ||
               (panel.segment == s.segment && panel.end < panel.parameterAt(s.u));
    };
    const auto panel = std::lower_bound(panels_.begin(), panels_.end(), spot, endsBefore);
    if (panel == panels_.end()) {
        return total();
    }
    return withSpeed((*pieces_)[panel->segment], halfOf(panel->start), [&](const auto& speed) {
        const double end = panel->parameterAt(spot.u);
        return finite(panel->lengthAtStart + speed.unit() * integral(speed, panel->start, end));
    });
}

void ArcLength::findOn(const Panel& panel, std::span<double> lengths) const {
    withSpeed((*pieces_)[panel.segment], halfOf(panel.start), [&](const auto& speed) {
        Walk(speed, chartError * total())
            .along({panel.start, panel.end}, panel.lengthAtStart, lengths);
    });
    if (panel.isFromEnd()) {
        std::ranges::transform(lengths, lengths.begin(), [](double x) { return 1 + x; });
    }
}

Spot ArcLength::spotAt(double length) const {
    if (panels_.empty() || !(length > 0)) {
        return {};
    }
    if (length >= total()) {
        return {panels_.back().segment, 1};
    }
    const auto& panel = *std::ranges::lower_bound(panels_, length, {}, &Panel::lengthAtEnd);
    findOn(panel, std::span(&length, 1));
    return {panel.segment, length};
}

std::vector<SpotRun> ArcLength::toParameters(std::span<double> lengths) const {
    std::vector<SpotRun> runs;
    const auto isAtStart = [](double length) { return !(length > 0); };
    const auto atStart =
        panels_.empty() ? lengths.end() : std::ranges::find_if_not(lengths, isAtStart);
    auto next = static_cast<std::size_t>(atStart - lengths.begin());
    std::fill(lengths.begin(), atStart, 0.0);
    const auto add = [&](std::size_t segment, std::size_t count) {
        if (runs.empty() || runs.back().segment != segment) {
            runs.push_back({segment, 0});
        }
        runs.back().count += count;
    };
    if (next > 0) {
        add(0, next);
    }
    auto panel = panels_.begin();
    while (next < lengths.size() && lengths[next] < total()) {
        // A few panels on, or far on.
        panel = panel->lengthAtEnd >= lengths[next]
                    ? panel
                    : std::ranges::lower_bound(panel, panels_.end(), lengths[next], {},
                                               &Panel::lengthAtEnd);
        auto after = next + 1;
        while (after < lengths.size() && lengths[after] <= panel->lengthAtEnd &&
               lengths[after] < total()) {
            ++after;
        }
        findOn(*panel, lengths.subspan(next, after - next));
        add(panel->segment, after - next);
        next = after;
    }
    if (next < lengths.size()) {
        std::ranges::fill(lengths.subspan(next), 1.0);
        add(panels_.back().segment, lengths.size() - next);
    }
    return runs;
}

std::vector<Spot> ArcLength::spotsAt(std::span<const double> lengths) const {
    std::vector<double> parameters(lengths.begin(), lengths.end());
    std::vector<Spot> spots;
    spots.reserve(lengths.size());
    for (const auto& run : toParameters(parameters)) {
        for (std::size_t i = 0; i < run.count; ++i) {
            spots.push_back({run.segment, parameters[spots.size()]});
        }
    }
    return spots;
}

} // namespace splineloft
