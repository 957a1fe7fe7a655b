#include "core/spline/measure/bounds.h"

#include "core/spline/algebra/bernstein.h"
#include "core/spline/algebra/roots.h"
#include "core/spline/algebra/scale.h"

#include <algorithm>
#include <cmath>

namespace splineloft {
namespace {

void include(Box& box, int coordinate, double value) {
    box.low[coordinate] = std::min(box.low[coordinate], value);
    box.high[coordinate] = std::max(box.high[coordinate], value);
}

/// The coordinate of each Bézier point.
std::vector<double> placesOf(const Piece& piece, int coordinate) {
    std::vector<double> places;
    for (int i = 0; i <= piece.degree; ++i) {
        places.push_back(piece.bezierPoint(i)[coordinate]);
    }
    return places;
}

/// A polynomial that is zero where the coordinate stands still: its derivative, times the weight
/// squared on a rational piece.
Bernstein levelSpots(const Piece& piece, int coordinate) {
    Bernstein own = piece.column(coordinate);
    const double scale = scaleFor(largestOf(own));
    std::ranges::transform(own, own.begin(), [=](double value) { return scale * value; });
    if (piece.form == Form::polynomial) {
        return derivative(own);
    }
    const Bernstein weight = piece.column(piece.dimension);
    return sum(product(derivative(own), weight), product(own, derivative(weight)), -1);
}

} // namespace

std::optional<Box> hullBox(const Pieces& pieces) {
    if (pieces.empty()) {
        return std::nullopt;
    }
    Box box{pieces[0].bezierPoint(0), pieces[0].bezierPoint(0)};
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        for (int k = 0; k <= pieces.degree(); ++k) {
            const Point place = pieces[i].bezierPoint(k);
            for (int c = 0; c < pieces.dimension(); ++c) {
                include(box, c, place[c]);
            }
        }
    }
    return box;
}

std::optional<Box> bounds(const Pieces& pieces) {
    if (pieces.empty()) {
        return std::nullopt;
    }
    Box box{pieces[0].bezierPoint(0), pieces[0].bezierPoint(0)};
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const Piece piece = pieces[i];
        for (int c = 0; c < piece.dimension; ++c) {
            const auto values = placesOf(piece, c);
            include(box, c, values.front());
            include(box, c, values.back());
            const auto [least, most] = std::ranges::minmax(values);
            if (least >= box.low[c] && most <= box.high[c]) {
                continue; // the hull is inside already, and so is the piece
            }
            for (const double u : rootsOf(levelSpots(piece, c))) {
                include(box, c, piece.position(u)[c]);
            }
        }
    }
    return box;
}

} // namespace splineloft
