#include "core/spline/measure/sample.h"

#include "core/spline/fast/lanes/place_lanes.h"

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
    const double over = 1 / static_cast<double>(count - 1);
    for (std::size_t i = 0; i < count; ++i) {
        even[i] = static_cast<double>(i) * over * total;
    }
    even.back() = total;
    return even;
}

/// Places at values of u on one polynomial cubic piece in the plane or in space.
void placesOnCubic(const Piece& piece, std::span<const double> u, std::span<double> places) {
    const auto dimension = static_cast<std::size_t>(piece.dimension);
    std::array<lanes::CubicFromEnds, 3> cubic;
    for (std::size_t k = 0; k < dimension; ++k) {
        const double* const p = &piece.coordinates[k];
        const double p0 = p[0], p1 = p[dimension], p2 = p[2 * dimension], p3 = p[3 * dimension];
        const double cube = (p3 - p0) + 3 * (p1 - p2);
        cubic[k] = {{p0, 3 * (p1 - p0), 3 * ((p2 - p1) - (p1 - p0)), cube},
                    {p3, 3 * (p2 - p3), 3 * ((p1 - p2) - (p2 - p3)), -cube}};
    }
    lanes::placeOnCubic(cubic, dimension, u.data(), u.size(), places.data());
}

/// Places at values of u on one piece.
void placesOn(const Piece& piece, std::span<const double> u, std::span<double> places) {
    if (piece.degree == 3 && piece.form == Form::polynomial &&
        (piece.dimension == 2 || piece.dimension == 3)) {
        return placesOnCubic(piece, u, places);
    }
    auto place = places.begin();
    for (const double at : u) {
        const Point position = piece.position(at);
        place = std::ranges::copy(position.coordinates(), place).out;
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
    auto u = evenLengths(lengths, count);
    std::size_t first = 0;
    for (const auto& run : lengths.toParameters(u)) {
        placesOn(pieces[run.segment], std::span(u).subspan(first, run.count),
                 places.subspan(first * stride, run.count * stride));
        first += run.count;
    }
    const double end = 1; // also where the curve has no length
    placesOn(pieces[pieces.size() - 1], std::span(&end, 1), places.last(stride));
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
