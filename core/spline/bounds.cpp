#include "core/spline/bounds.h"

#include "core/spline/roots.h"

#include <algorithm>

namespace splineloft {
namespace {

void include(Box& box, int coordinate, double value) {
    box.low[coordinate] = std::min(box.low[coordinate], value);
    box.high[coordinate] = std::max(box.high[coordinate], value);
}

/// One coordinate of a piece's Bézier points.
std::vector<double> column(const Piece& piece, int coordinate) {
    std::vector<double> values;
    for (int i = 0; i <= piece.degree; ++i) {
        values.push_back(piece.bezierPoint(i)[coordinate]);
    }
    return values;
}

} // namespace

std::optional<Box> hullBox(const Pieces& pieces) {
    if (pieces.empty()) {
        return std::nullopt;
    }
    Box box{pieces[0].bezierPoint(0), pieces[0].bezierPoint(0)};
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const auto coordinates = pieces[i].coordinates;
        for (std::size_t k = 0; k < coordinates.size(); ++k) {
            include(box, static_cast<int>(k) % pieces.dimension(), coordinates[k]);
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
            const auto values = column(piece, c);
            include(box, c, values.front());
            include(box, c, values.back());
            const auto [least, most] = std::ranges::minmax(values);
            if (least >= box.low[c] && most <= box.high[c]) {
                continue; // the hull is inside already, and so is the piece
            }
            std::vector<double> steps;
            for (std::size_t k = 0; k + 1 < values.size(); ++k) {
                steps.push_back(values[k + 1] - values[k]);
            }
            for (const double u : rootsOf(steps)) {
                include(box, c, piece.position(u)[c]);
            }
        }
    }
    return box;
}

} // namespace splineloft
