#include "core/spline/sample.h"

namespace splineloft {

std::vector<Spot> spread(const Pieces& pieces, const ArcLength& lengths, Even even,
                         std::size_t count) {
    std::vector<Spot> spots;
    if (pieces.empty() || count < 2) {
        return spots;
    }
    const auto& knots = pieces.knots();
    for (std::size_t i = 0; i < count; ++i) {
        const double part = static_cast<double>(i) / static_cast<double>(count - 1);
        spots.push_back(even == Even::length
                            ? lengths.spotAt(part * lengths.total())
                            : knots.locate(lerp(knots.start(), knots.end(), part)));
    }
    return spots;
}

std::vector<Spot> spreadPerPiece(const Pieces& pieces, std::size_t perPiece) {
    std::vector<Spot> spots;
    if (pieces.empty() || perPiece == 0) {
        return spots;
    }
    for (std::size_t segment = 0; segment < pieces.size(); ++segment) {
        for (std::size_t k = 0; k < perPiece; ++k) {
            spots.push_back({segment, static_cast<double>(k) / static_cast<double>(perPiece)});
        }
    }
    spots.push_back({pieces.size() - 1, 1});
    return spots;
}

std::vector<Sample> samplesAt(const Pieces& pieces, const ArcLength& lengths,
                              const std::vector<Spot>& spots) {
    std::vector<Sample> samples;
    samples.reserve(spots.size());
    for (const auto& spot : spots) {
        const Jet jet = pieces.jetByParameter(spot);
        samples.push_back({spot, pieces.knots().parameter(spot), lengths.upTo(spot), jet.position,
                           jet.first, jet.curvature});
    }
    return samples;
}

} // namespace splineloft
