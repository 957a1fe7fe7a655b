// Tridiagonal systems whose diagonals outweigh their rows, as those of natural splines are:
// below[i] z[i-1] + diagonal[i] z[i] + above[i] z[i+1] = right[i], where the first `below` and the
// last `above` do not count. One entrance, solveTridiagonal; numbers in plenty take a faster way.
#pragma once

#include "core/spline/blend.h"

#include <concepts>
#include <cstddef>
#include <span>
#include <vector>

namespace splineloft::families {

/// Rows of a system, all four parts equally long.
template <Blendable T> struct Rows {
    std::span<const double> below, diagonal, above;
    std::span<const T> right;
};

/// Solves by elimination without pivoting (Thomas 1949), row after row. It is safe where every
/// diagonal is at least as large as the two beside it together. O(n), about 8 ns a row: the next
/// row waits for the division of this one.
template <Blendable T> std::vector<T> solveRowByRow(const Rows<T>& rows) {
    const auto n = rows.right.size();
    std::vector<double> over(n);
    std::vector<T> solution(rows.right.begin(), rows.right.end());
    for (std::size_t i = 0; i < n; ++i) {
        const bool first = i == 0;
        const double pivot = rows.diagonal[i] - (first ? 0 : rows.below[i] * over[i - 1]);
        const double inverse = 1 / pivot;
        over[i] = rows.above[i] * inverse;
        solution[i] =
            inverse * (first ? rows.right[i] : rows.right[i] - rows.below[i] * solution[i - 1]);
    }
    for (std::size_t i = n; i-- > 1;) {
        solution[i - 1] = solution[i - 1] - over[i - 1] * solution[i];
    }
    return solution;
}

/// The solution that solveRowByRow finds, bit for bit (where the compiler does not fuse products
/// into sums differently in the two), into `solution`, several times as fast.
void solveInChains(const Rows<double>& rows, std::span<double> solution);

/// Solves a system of any size. O(n).
template <Blendable T> std::vector<T> solveTridiagonal(const Rows<T>& rows) {
    if constexpr (std::same_as<T, double>) {
        std::vector<double> solution(rows.right.size());
        solveInChains(rows, solution);
        return solution;
    } else {
        return solveRowByRow(rows);
    }
}

} // namespace splineloft::families
