#include "core/spline/shape/subdivide.h"

#include <algorithm>

namespace splineloft {
namespace {

std::size_t numbersOf(const Pieces& pieces) {
    return pieces.empty() ? 0 : pieces[0].coordinates.size();
}

/// The same spot with a segment that exists and 0 <= u <= 1.
Spot inside(const Pieces& pieces, Spot spot) {
    if (spot.segment >= pieces.size()) {
        return {pieces.size() - 1, 1};
    }
    return {spot.segment, spot.u > 0 ? std::min(spot.u, 1.0) : 0.0};
}

/// The parameter of a spot. It lies between the spot's knots even where rounding would not have it.
double knotAt(const Pieces& pieces, Spot spot) {
    const auto knots = pieces.knots().knots();
    return std::clamp(pieces.knots().parameter(spot), knots[spot.segment], knots[spot.segment + 1]);
}

void append(std::vector<double>& all, std::span<const double> more) {
    all.insert(all.end(), more.begin(), more.end());
}

Pieces alike(const Pieces& pieces, std::vector<double> knots, std::vector<double> bezier) {
    return {pieces.degree(), pieces.dimension(), KnotLine(std::move(knots)), std::move(bezier),
            pieces.form()};
}

} // namespace

Halves halved(const Piece& piece, double u) {
    const auto width = static_cast<std::size_t>(piece.width());
    Halves halves;
    halves.before.reserve(piece.coordinates.size());
    halves.after.assign(piece.coordinates.begin(), piece.coordinates.end());
    // Climbing in place leaves the last rung of every level where it was: the right side.
    auto& rungs = halves.after;
    for (std::size_t left = rungs.size(); left > 0; left -= width) {
        append(halves.before, std::span(rungs).first(width));
        for (std::size_t i = 0; i + width < left; ++i) {
            rungs[i] = lerp(rungs[i], rungs[i + width], u);
        }
    }
    return halves;
}

std::vector<double> stretchOf(const Piece& piece, double from, double to) {
    Piece shorter = piece;
    std::vector<double> points(piece.coordinates.begin(), piece.coordinates.end());
    if (to < 1) {
        points = halved(piece, to).before;
        shorter.coordinates = points;
    }
    // `from` lies from / to of the way along what is left.
    return from > 0 && to > 0 ? halved(shorter, from / to).after : points;
}

Pieces subdivided(const Pieces& pieces, Spot spot) {
    if (pieces.empty()) {
        return pieces;
    }
    spot = inside(pieces, spot);
    if (spot.u == 0 || spot.u == 1) {
        return pieces;
    }
    const auto at = static_cast<std::ptrdiff_t>(spot.segment);
    const auto line = pieces.knots().knots();
    std::vector<double> knots(line.begin(), line.end());
    knots.insert(knots.begin() + at + 1, knotAt(pieces, spot));

    const auto [before, after] = halved(pieces[spot.segment], spot.u);
    const auto length = numbersOf(pieces);
    std::vector<double> bezier;
    bezier.reserve(pieces.bezier().size() + length);
    append(bezier, pieces.bezier().first(spot.segment * length));
    append(bezier, before);
    append(bezier, after);
    append(bezier, pieces.bezier().subspan((spot.segment + 1) * length));
    return alike(pieces, std::move(knots), std::move(bezier));
}

Pieces part(const Pieces& pieces, Spot from, Spot to) {
    if (pieces.empty()) {
        return pieces;
    }
    from = inside(pieces, from);
    to = inside(pieces, to);
    // A joint belongs to the piece that the part has of it.
    if (from.u == 1 && from.segment + 1 < pieces.size()) {
        from = {from.segment + 1, 0};
    }
    if (to.u == 0 && to.segment > 0) {
        to = {to.segment - 1, 1};
    }
    if (to.segment < from.segment || (to.segment == from.segment && to.u <= from.u)) {
        return alike(pieces, {}, {});
    }
    std::vector<double> knots = {knotAt(pieces, from)};
    std::vector<double> bezier;
    for (std::size_t i = from.segment; i <= to.segment; ++i) {
        const double low = i == from.segment ? from.u : 0;
        const double high = i == to.segment ? to.u : 1;
        knots.push_back(std::max(knots.back(), knotAt(pieces, {i, high})));
        append(bezier, stretchOf(pieces[i], low, high));
    }
    return alike(pieces, std::move(knots), std::move(bezier));
}

Pieces reversed(const Pieces& pieces) {
    if (pieces.empty()) {
        return pieces;
    }
    const KnotLine& line = pieces.knots();
    std::vector<double> knots;
    for (std::size_t i = 0; i <= pieces.size(); ++i) {
        knots.push_back(line.start() + (line.end() - line.knots()[pieces.size() - i]));
    }
    const auto width = static_cast<std::size_t>(pieces[0].width());
    std::vector<double> bezier;
    bezier.reserve(pieces.bezier().size());
    for (auto rest = pieces.bezier(); !rest.empty(); rest = rest.first(rest.size() - width)) {
        append(bezier, rest.last(width));
    }
    return alike(pieces, std::move(knots), std::move(bezier));
}

} // namespace splineloft
