#include "core/spline/shape/hodograph.h"

#include "core/spline/algebra/bernstein.h"

#include <algorithm>

namespace splineloft {
namespace {

int degreeOfHodograph(int degree, Form form) {
    return form == Form::rational ? 2 * degree : std::max(degree - 1, 0);
}

/// The Bernstein coefficients of each of the hodograph's numbers, as `Piece::column`.
std::vector<Bernstein> columnsOf(const Piece& piece) {
    std::vector<Bernstein> columns;
    for (int c = 0; c < piece.dimension; ++c) {
        columns.push_back(derivative(piece.column(c)));
    }
    if (piece.form == Form::rational) {
        // (A / w)' = (A' w - A w') / w^2. The numerator is of degree 2d - 1.
        const Bernstein weight = piece.column(piece.dimension);
        for (int c = 0; c < piece.dimension; ++c) {
            auto& column = columns[static_cast<std::size_t>(c)];
            const Bernstein falling = product(piece.column(c), derivative(weight));
            column = elevated(sum(product(column, weight), falling, -1), 2 * piece.degree);
        }
        columns.push_back(product(weight, weight));
    }
    return columns;
}

void append(std::vector<double>& bezier, const Piece& piece) {
    const auto columns = columnsOf(piece);
    for (std::size_t i = 0; i < columns.front().size(); ++i) {
        for (const auto& column : columns) {
            bezier.push_back(column[i]);
        }
    }
}

} // namespace

Pieces hodograph(const Pieces& pieces) {
    std::vector<double> bezier;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        append(bezier, pieces[i]);
    }
    return {degreeOfHodograph(pieces.degree(), pieces.form()), pieces.dimension(), pieces.knots(),
            std::move(bezier), pieces.form()};
}

Pieces hodograph(const Piece& piece) {
    std::vector<double> bezier;
    append(bezier, piece);
    return {degreeOfHodograph(piece.degree, piece.form), piece.dimension, KnotLine({0, 1}),
            std::move(bezier), piece.form};
}

} // namespace splineloft
