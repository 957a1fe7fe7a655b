#include "core/spline/shape/arcs.h"

#include "core/spline/algebra/rounded.h"
#include "core/spline/algebra/scale.h"
#include "core/spline/shape/subdivide.h"

#include <algorithm>
#include <cmath>

namespace splineloft {
namespace {

/// The power of two that makes every coordinate smaller than 1.
int exponentOf(const Pieces& pieces) {
    double farthest = 0;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        for (int k = 0; k <= pieces.degree(); ++k) {
            const Point place = pieces[i].bezierPoint(k);
            for (const double x : place.coordinates()) {
                farthest = std::max(farthest, std::abs(x));
            }
        }
    }
    int exponent = 0;
    std::frexp(std::isfinite(farthest) ? farthest : 1, &exponent);
    return exponent;
}

/// Where x or y stands still inside of a piece, in order.
std::vector<double> levelSpots(const Piece& piece) {
    const LocalPiece local = localPiece(piece, piece.bezierPoint(0));
    std::vector<double> spots;
    for (int c = 0; c < 2; ++c) {
        for (const double u : local.velocity(c).roots()) {
            if (u > 0 && u < 1) {
                spots.push_back(u);
            }
        }
    }
    std::ranges::sort(spots);
    return spots;
}

/// Fills in box, direction and rounding.
void measure(Arc& arc, const Piece& shape) {
    Piece piece = shape;
    piece.coordinates = arc.bezier;
    const Point start = piece.bezierPoint(0);
    const Point end = piece.bezierPoint(piece.degree);
    double farthest = 0;
    for (int c = 0; c < 2; ++c) {
        // Monotone within rounding: the ends are the corners.
        const auto at = static_cast<std::size_t>(c);
        arc.least[at] = std::min(start[c], end[c]);
        arc.greatest[at] = std::max(start[c], end[c]);
        farthest = std::max({farthest, std::abs(start[c]), std::abs(end[c])});
    }
    arc.rounding = 16 * epsilon * farthest;
    for (int c = 0; c < 2; ++c) {
        const double way = end[c] - start[c];
        arc.runs[static_cast<std::size_t>(c)] =
            way > arc.rounding ? 1 : (way < -arc.rounding ? -1 : 0);
    }
}

} // namespace

std::vector<Arc> arcsOf(const Pieces& pieces) {
    const int exponent = exponentOf(pieces);
    std::vector<Arc> arcs;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        Piece shape = pieces[i];
        std::vector<double> rest(shape.coordinates.begin(), shape.coordinates.end());
        for (std::size_t k = 0; k < rest.size(); ++k) {
            const bool isWeight = shape.form == Form::rational && k % 3 == 2; // x, y and the weight
            rest[k] = isWeight ? rest[k] : std::ldexp(rest[k], -exponent);
        }
        std::vector<double> ends = levelSpots(shape);
        ends.push_back(1);
        double low = 0;
        for (const double high : ends) {
            if (!(high > low)) {
                continue;
            }
            shape.coordinates = rest;
            Arc arc{{}, i, low, high, {}, {}, {}, 0};
            if (high < 1) {
                Halves halves = halved(shape, (high - low) / (1 - low));
                arc.bezier = std::move(halves.before);
                rest = std::move(halves.after);
            } else {
                arc.bezier = rest;
            }
            measure(arc, shape);
            low = high;
            if (arc.runs[0] != 0 || arc.runs[1] != 0) {
                arcs.push_back(std::move(arc));
            }
        }
    }
    return arcs;
}

} // namespace splineloft
