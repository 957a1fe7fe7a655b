#include "core/spline/change/basis_change.h"

#include <algorithm>
#include <optional>
#include <stdexcept>

namespace splineloft {
namespace {

using Parameters = std::vector<Rational>;
using R = Rational;

RationalMatrix times(Rational factor, RationalMatrix matrix) {
    for (int row = 0; row < matrix.size(); ++row) {
        for (int column = 0; column < matrix.size(); ++column) {
            matrix.at(row, column) = factor * matrix.at(row, column);
        }
    }
    return matrix;
}

// clang-format off

RationalMatrix power(const Parameters&) {
    return {4, {1, 0, 0, 0,
                0, 1, 0, 0,
                0, 0, 1, 0,
                0, 0, 0, 1}};
}

RationalMatrix bezier(const Parameters&) {
    return {4, {-1,  3, -3, 1,
                 3, -6,  3, 0,
                -3,  3,  0, 0,
                 1,  0,  0, 0}};
}

/// The inverse of Smith's M1: start, end, and the tangents there.
RationalMatrix hermite(const Parameters&) {
    return {4, { 2, -2,  1,  1,
                -3,  3, -2, -1,
                 0,  0,  1,  0,
                 1,  0,  0,  0}};
}

RationalMatrix cardinal(const Parameters& p) {
    const R a = p[0];
    return {4, {R(-1) * a,  R(2) - a,  a - R(2),           a,
                R(2) * a,   a - R(3),  R(3) - R(2) * a,    R(-1) * a,
                R(-1) * a,  0,         a,                  0,
                0,          1,         0,                  0}};
}

RationalMatrix catmullRom(const Parameters&) {
    return times({1, 2}, {4, {-1,  3, -3,  1,
                               2, -5,  4, -1,
                              -1,  0,  1,  0,
                               0,  2,  0,  0}});
}

RationalMatrix bSpline(const Parameters&) {
    return times({1, 6}, {4, {-1,  3, -3, 1,
                               3, -6,  3, 0,
                              -3,  0,  3, 0,
                               1,  4,  1, 0}});
}

RationalMatrix duff(const Parameters& p) {
    const R a = p[0];
    return times({1, 6}, {4, {R(-1) * a,  R(12) - R(9) * a,   R(9) * a - R(12),   a,
                              R(3) * a,   R(12) * a - R(18),  R(18) - R(15) * a,  0,
                              R(-3) * a,  0,                  R(3) * a,           0,
                              a,          R(6) - R(2) * a,    a,                  0}});
}

RationalMatrix beta(const Parameters& p) {
    const R b1 = p[0], b2 = p[1];
    const R sq = b1 * b1, cu = b1 * sq;
    const R delta = b2 + R(2) * cu + R(4) * sq + R(4) * b1 + R(2);
    return times(R(1) / delta,
        {4, {R(-2) * cu,  R(2) * (b2 + cu + sq + b1),           R(-2) * (b2 + sq + b1 + R(1)),  2,
             R(6) * cu,   R(-3) * (b2 + R(2) * cu + R(2) * sq), R(3) * (b2 + R(2) * sq),        0,
             R(-6) * cu,  R(6) * (cu - b1),                     R(6) * b1,                      0,
             R(2) * cu,   b2 + R(4) * (sq + b1),                2,                              0}});
}

/// Mitchell and Netravali's filter, piece by piece in u.
RationalMatrix bcSpline(const Parameters& p) {
    const R b = p[0], c = p[1];
    const R near = R(12) - R(9) * b - R(6) * c;
    return times({1, 6},
        {4, {R(-1) * b - R(6) * c,      near,                             R(-1) * near,                    b + R(6) * c,
             R(3) * b + R(12) * c,      R(-18) + R(12) * b + R(6) * c,    R(18) - R(15) * b - R(12) * c,   R(-6) * c,
             R(-3) * b - R(6) * c,      0,                                R(3) * b + R(6) * c,             0,
             b,                         R(6) - R(2) * b,                  b,                               0}});
}

/// The tangents, leaving and arriving, put into the Hermite form.
RationalMatrix kochanekBartels(const Parameters& p) {
    const R half = (R(1) - p[0]) * R(1, 2), c = p[1], b = p[2];
    const R before0 = half * (R(1) + c) * (R(1) + b), after0 = half * (R(1) - c) * (R(1) - b);
    const R before1 = half * (R(1) - c) * (R(1) + b), after1 = half * (R(1) + c) * (R(1) - b);
    const RationalMatrix given(
        4, {0,                1,                 0,                 0,
            0,                0,                 1,                 0,
            R(-1) * before0,  before0 - after0,  after0,            0,
            0,                R(-1) * before1,   before1 - after1,  after1});
    return hermite({}) * given;
}

// clang-format on

/// A row of the table.
struct Entry {
    std::string_view id;
    std::size_t parameters;
    RationalMatrix (*matrix)(const Parameters&);
};

constexpr Entry entries[] = {
    {"power", 0, power},
    {"bezier", 0, bezier},
    {"hermite", 0, hermite},
    {"cardinal", 1, cardinal},
    {"catmull-rom", 0, catmullRom},
    {"b-spline", 0, bSpline},
    {"duff", 1, duff},
    {"beta", 2, beta},
    {"bc-spline", 2, bcSpline},
    {"kochanek-bartels", 3, kochanekBartels},
};

/// Subtracts multiples of row `pivot` from all others, so that its column has a 1 there and zeros
/// elsewhere.
void clearColumn(RationalMatrix& matrix, RationalMatrix& beside, int pivot) {
    const Rational scale = Rational(1) / matrix.at(pivot, pivot);
    for (int column = 0; column < matrix.size(); ++column) {
        matrix.at(pivot, column) = scale * matrix.at(pivot, column);
        beside.at(pivot, column) = scale * beside.at(pivot, column);
    }
    for (int row = 0; row < matrix.size(); ++row) {
        const Rational share = matrix.at(row, pivot);
        for (int column = 0; column < matrix.size() && row != pivot; ++column) {
            matrix.at(row, column) = matrix.at(row, column) - share * matrix.at(pivot, column);
            beside.at(row, column) = beside.at(row, column) - share * beside.at(pivot, column);
        }
    }
}

/// matrix^-1 * right, by Gauss and Jordan's elimination; nothing where the matrix is singular.
std::optional<RationalMatrix> solved(RationalMatrix matrix, RationalMatrix right) {
    for (int pivot = 0; pivot < matrix.size(); ++pivot) {
        int row = pivot;
        while (row < matrix.size() && matrix.at(row, pivot) == Rational(0)) {
            ++row;
        }
        if (row == matrix.size()) {
            return std::nullopt;
        }
        for (int column = 0; column < matrix.size() && row != pivot; ++column) {
            std::swap(matrix.at(row, column), matrix.at(pivot, column));
            std::swap(right.at(row, column), right.at(pivot, column));
        }
        clearColumn(matrix, right, pivot);
    }
    return right;
}

Problem tooLarge() {
    return {"", "needs numbers of more than 64 bits", "fractions of smaller whole numbers"};
}

Problem singular(std::string_view id) {
    return {"/parameters", std::string(id) + " does not draw every cubic with these parameters",
            "others: a tension of 0 draws straight lines only"};
}

/// Row by row: binomial(degree, column) binomial(degree - column, power - column) (-1)^(power -
/// column), the coefficient of u^power in Bernstein polynomial number `column`.
RationalMatrix bernsteinMatrix(int degree) {
    RationalMatrix matrix(degree + 1);
    Rational outer = 1; // binomial(degree, column)
    for (int column = 0; column <= degree; ++column) {
        Rational entry = outer;
        for (int exponent = column; exponent <= degree; ++exponent) {
            matrix.at(degree - exponent, column) = entry;
            entry = entry * Rational(column - degree + (exponent - column), exponent - column + 1);
        }
        if (column < degree) {
            outer = outer * Rational(degree - column, column + 1);
        }
    }
    return matrix;
}

/// The inverse: u^exponent has the Bézier points binomial(i, exponent) / binomial(degree,
/// exponent), which go from one i to the next by a quotient of small whole numbers.
RationalMatrix powerPoints(int degree) {
    RationalMatrix matrix(degree + 1);
    for (int exponent = 0; exponent <= degree; ++exponent) {
        Rational entry = 1; // at i = degree
        for (int i = degree; i >= exponent; --i) {
            matrix.at(i, degree - exponent) = entry;
            if (i > exponent) {
                entry = entry * Rational(i - exponent, i);
            }
        }
    }
    return matrix;
}

MatrixOrProblem matrixOfDegree(int degree, RationalMatrix (*matrix)(int)) {
    constexpr int highest = 1000; // long before that the numbers do not fit
    if (degree < 0 || degree > highest) {
        return Problem{"/degree", "is " + std::to_string(degree), "0 or a little more"};
    }
    try {
        auto found = matrix(degree);
        static_cast<void>(found.denominator());
        return found;
    } catch (const std::overflow_error&) {
        return tooLarge();
    }
}

} // namespace

std::vector<std::string_view> cubicBases() {
    std::vector<std::string_view> ids;
    for (const auto& entry : entries) {
        ids.push_back(entry.id);
    }
    return ids;
}

MatrixOrProblem powerMatrix(const CubicBasis& basis) {
    const auto entry = std::ranges::find(entries, basis.id, &Entry::id);
    if (entry == std::end(entries)) {
        return Problem{"/id", "there is no matrix for \"" + std::string(basis.id) + "\"",
                       "a uniform cubic, such as cardinal, b-spline or bezier"};
    }
    if (basis.parameters.size() != entry->parameters) {
        return Problem{"/parameters",
                       std::to_string(basis.parameters.size()) + " numbers are given",
                       std::to_string(entry->parameters)};
    }
    try {
        return entry->matrix(basis.parameters);
    } catch (const std::overflow_error&) {
        return tooLarge();
    } catch (const std::domain_error&) {
        return Problem{"/parameters", "the matrix has a denominator of 0", "other values"};
    }
}

MatrixOrProblem basisChange(const CubicBasis& from, const CubicBasis& to) {
    const auto source = powerMatrix(from);
    const auto target = powerMatrix(to);
    for (const auto* each : {&source, &target}) {
        if (std::holds_alternative<Problem>(*each)) {
            return *each;
        }
    }
    try {
        const auto change =
            solved(std::get<RationalMatrix>(target), std::get<RationalMatrix>(source));
        if (!change) {
            return singular(to.id);
        }
        return *change;
    } catch (const std::overflow_error&) {
        return tooLarge();
    }
}

MatrixOrProblem bezierToPower(int degree) {
    return matrixOfDegree(degree, bernsteinMatrix);
}

MatrixOrProblem powerToBezier(int degree) {
    return matrixOfDegree(degree, powerPoints);
}

} // namespace splineloft
