#include "core/spline/measure/sample.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>

namespace splineloft {
namespace {

/// `count` lengths from 0 to the total, in equal steps.
std::vector<double> evenLengths(const ArcLength& lengths, std::size_t count) {
    std::vector<double> even(count);
    const double total = lengths.total();
    for (std::size_t i = 0; i < count; ++i) {
        even[i] = static_cast<double>(i) / static_cast<double>(count - 1) * total;
    }
    return even;
}

/// Places of spots of one polynomial cubic piece, from the powers of u about its nearer end.
template <std::size_t dimension>
void placesOnCubic(const Piece& piece, std::span<const Spot> spots, double* places) {
    const double* const p = piece.coordinates.data();
    std::array<std::array<double, 4>, dimension> rise, fall;
    for (std::size_t k = 0; k < dimension; ++k) {
        const double p0 = p[k], p1 = p[dimension + k];
        const double p2 = p[2 * dimension + k], p3 = p[3 * dimension + k];
        const double cube = (p3 - p0) + 3 * (p1 - p2);
        rise[k] = {p0, 3 * (p1 - p0), 3 * ((p2 - p1) - (p1 - p0)), cube};
        fall[k] = {p3, 3 * (p2 - p3), 3 * ((p1 - p2) - (p2 - p3)), -cube};
    }
    for (const auto& spot : spots) {
        const bool isEarly = spot.u <= 0.5;
        const auto& powers = isEarly ? rise : fall;
        const double v = isEarly ? spot.u : 1 - spot.u;
        for (const auto& c : powers) {
            *places++ = c[0] + v * (c[1] + v * (c[2] + v * c[3]));
        }
    }
}

/// Places of spots of one piece.
void placesOn(const Piece& piece, std::span<const Spot> spots, double* places) {
    if (piece.degree == 3 && piece.form == Form::polynomial && piece.dimension == 2) {
        return placesOnCubic<2>(piece, spots, places);
    }
    if (piece.degree == 3 && piece.form == Form::polynomial && piece.dimension == 3) {
        return placesOnCubic<3>(piece, spots, places);
    }
    for (const auto& spot : spots) {
        const Point position = piece.position(spot.u);
        places = std::ranges::copy(position.coordinates(), places).out;
    }
}

} // namespace

std::vector<Spot> spread(const Pieces& pieces, const ArcLength& lengths, Even even,
                         std::size_t count) {
    if (pieces.empty() || count < 2) {
        return {};
    }
    if (even == Even::length) {
        auto spots = lengths.spotsAt(evenLengths(lengths, count));
        spots.back() = {pieces.size() - 1, 1}; // also where the curve has no length
        return spots;
    }
    std::vector<Spot> spots;
    spots.reserve(count);
    const auto& knots = pieces.knots();
    for (std::size_t i = 0; i < count; ++i) {
        const double part = static_cast<double>(i) / static_cast<double>(count - 1);
        spots.push_back(knots.locate(lerp(knots.start(), knots.end(), part)));
    }
    return spots;
}

std::vector<Spot> spreadByDistance(const Pieces& pieces, const ArcLength& lengths, double distance,
                                   Remainder remainder) {
    if (!(distance > 0)) {
        throw std::invalid_argument("the distance of spots must be above zero");
    }
    if (pieces.empty()) {
        return {};
    }
    // A rest below this part of the whole is rounding, be it of the length or of the distance.
    constexpr double rounding = 1e-12;
    const double total = lengths.total();
    const double steps = total / distance * (1 + rounding);
    if (!(steps < static_cast<double>(mostSpots - 1))) {
        throw std::invalid_argument(
            "spots " + std::to_string(distance) + " apart on a curve of length " +
            std::to_string(total) + " would be more than " + std::to_string(mostSpots) +
            ": they must be at least " +
            std::to_string(total / static_cast<double>(mostSpots - 2)) + " apart");
    }
    const auto whole = static_cast<std::size_t>(steps);
    std::vector<double> at(whole + 1);
    for (std::size_t i = 0; i <= whole; ++i) {
        at[i] = static_cast<double>(i) * distance;
    }
    const bool reachesEnd = total - at.back() <= rounding * total;
    if (reachesEnd) {
        at.back() = whole > 0 ? total : 0;
    } else if (remainder == Remainder::capped) {
        at.push_back(total);
    }
    return lengths.spotsAt(at);
}

void spreadPlaces(const Pieces& pieces, const ArcLength& lengths, std::size_t count,
                  std::span<double> places) {
    const auto stride = static_cast<std::size_t>(pieces.dimension());
    if (pieces.empty() || count < 2) {
        return;
    }
    if (places.size() != count * stride) {
        throw std::invalid_argument("the room for places must be " + std::to_string(count) +
                                    " points of " + std::to_string(stride) + " numbers");
    }
    const auto spots = spread(pieces, lengths, Even::length, count);
    for (std::size_t first = 0; first < count;) {
        auto after = first + 1;
        while (after < count && spots[after].segment == spots[first].segment) {
            ++after;
        }
        placesOn(pieces[spots[first].segment], std::span(spots).subspan(first, after - first),
                 &places[first * stride]);
        first = after;
    }
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
