// The uniform cubics as matrices of fractions, and how to get from one to another: which points to
// give to one family so that it draws what another draws from its own. Exact, as the textbook
// prints it.
#pragma once

#include "core/spline/algebra/rational.h"
#include "core/spline/problem.h"

#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace splineloft {

/// A square matrix of fractions, row by row.
class RationalMatrix {
  public:
    /// Of zeros.
    explicit RationalMatrix(int size);
    /// From size x size numbers, row by row.
    RationalMatrix(int size, std::vector<Rational> entries);

    int size() const { return size_; }
    Rational at(int row, int column) const { return entries_[index(row, column)]; }
    Rational& at(int row, int column) { return entries_[index(row, column)]; }
    /// The least number that makes whole numbers of all entries. Throws std::overflow_error.
    std::int64_t denominator() const;
    bool operator==(const RationalMatrix&) const = default;

  private:
    std::size_t index(int row, int column) const {
        return static_cast<std::size_t>(row * size_ + column);
    }
    int size_;
    std::vector<Rational> entries_;
};

/// Exact; throws std::overflow_error where an entry does not fit in 64 bits.
RationalMatrix operator*(const RationalMatrix& a, const RationalMatrix& b);

/// As the textbook prints it, one row a line: `1/6 [ -1  3 -3 1 ]`, the factor on the first one.
std::string textOf(const RationalMatrix& matrix);

/// A way of giving a cubic: the id of a family, or "power", and values of its parameters in the
/// order given here. What is given besides is a column of four:
/// - power: no parameters; a3, a2, a1, a0, the coefficients of u^3, u^2, u and 1
/// - hermite: none; start, end, tangent at the start and at the end (Smith 1983, M1)
/// - bezier: none; its four points, as with all that follow (lecture, Bernstein)
/// - cardinal: tension (Smith 1983)
/// - catmull-rom, b-spline: none (Smith 1983)
/// - duff: tension (Duff, in Smith 1983)
/// - beta: bias, tension (Barsky 1981)
/// - bc-spline: b, c (Mitchell and Netravali 1988)
/// - kochanek-bartels: tension, continuity, bias (Kochanek and Bartels 1984)
struct CubicBasis {
    std::string_view id;
    std::vector<Rational> parameters;
};

/// A matrix, or why there is none.
using MatrixOrProblem = std::variant<RationalMatrix, Problem>;

/// The ids of the table above.
std::vector<std::string_view> cubicBases();

/// The matrix M of a basis, as Smith (1983) writes it: the cubic is [u^3 u^2 u 1] M P, where P is
/// the column of what is given. A problem where there is no such basis, the number of parameters is
/// wrong, a denominator is zero (beta with delta = 0) or a number needs more than 64 bits.
MatrixOrProblem powerMatrix(const CubicBasis& basis);

/// The matrix that makes of what is given to `from` what must be given to `to` for the same cubic:
/// M_to^-1 M_from. A problem, besides those of `powerMatrix`, where `to` cannot draw every cubic:
/// its matrix is singular, as that of the cardinal spline of tension 0, which draws lines only.
MatrixOrProblem basisChange(const CubicBasis& from, const CubicBasis& to);

/// From Bézier points to the coefficients of u^degree, ..., u, 1. A problem where `degree` is below
/// 0 or a number needs more than 64 bits.
MatrixOrProblem bezierToPower(int degree);

/// The way back: from power coefficients to Bézier points.
MatrixOrProblem powerToBezier(int degree);

} // namespace splineloft
