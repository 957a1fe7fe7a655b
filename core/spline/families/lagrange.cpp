// Lagrange: the one polynomial of degree n - 1 through all n points, at even parameter values. Best
// known for how wildly it swings (Runge 1901).
#include "core/spline/family.h"

#include <algorithm>
#include <vector>

namespace splineloft::families {
namespace {

// The weights grow like 2^n: beyond this little of a double would be left.
constexpr std::size_t mostWeighedPoints = 24;

/// Which weights of the points give the Bézier points: the inverse of the matrix of Bernstein
/// polynomials at the parameter values. Every minor of that matrix is positive, so elimination
/// needs no pivoting; long double keeps what it loses out of the result.
std::vector<long double> bernsteinInverse(std::size_t n) {
    const auto d = n - 1;
    std::vector<long double> matrix(n * 2 * n);
    const auto at = [&](std::size_t row, std::size_t column) -> long double& {
        return matrix[row * 2 * n + column];
    };
    for (std::size_t i = 0; i < n; ++i) {
        const long double u = static_cast<long double>(i) / static_cast<long double>(d);
        std::vector<long double> bernstein = {1};
        for (std::size_t k = 1; k < n; ++k) {
            bernstein.push_back(0);
            for (std::size_t j = k + 1; j-- > 0;) {
                bernstein[j] = (1 - u) * bernstein[j] + (j > 0 ? u * bernstein[j - 1] : 0);
            }
        }
        std::ranges::copy(bernstein, &at(i, 0));
        at(i, n + i) = 1;
    }
    for (std::size_t pivot = 0; pivot < n; ++pivot) {
        for (std::size_t row = 0; row < n; ++row) {
            const long double factor = row == pivot ? 0 : at(row, pivot) / at(pivot, pivot);
            for (std::size_t column = pivot; factor != 0 && column < 2 * n; ++column) {
                at(row, column) -= factor * at(pivot, column);
            }
        }
    }
    std::vector<long double> inverse;
    for (std::size_t row = 0; row < n; ++row) {
        for (std::size_t column = 0; column < n; ++column) {
            inverse.push_back(at(row, n + column) / at(row, row));
        }
    }
    return inverse;
}

struct Lagrange {
    template <Blendable T>
    static void piece(const Input<T>& input, std::size_t, std::span<T> bezier) {
        const auto n = input.points.size();
        const auto weights = bernsteinInverse(n);
        for (std::size_t row = 0; row < n; ++row) {
            bezier[row] = T{};
            for (std::size_t column = 0; column < n; ++column) {
                bezier[row] = bezier[row] +
                              static_cast<double>(weights[row * n + column]) * input.points[column];
            }
        }
        bezier.front() = input.points.front();
        bezier.back() = input.points.back();
    }
};

} // namespace

Family lagrange() {
    return localFamily<Lagrange>({
        .id = "lagrange",
        .name = "Lagrange",
        .summary =
            "The one polynomial of degree n − 1 through every point: exact, and wild between.",
        .source = "Waring 1779 · Lagrange 1795",
        .ends = {Ends::none},
        .closable = false,
        .mostPoints = mostWeighedPoints,
        .mostCoordinate = 1e290, // second derivatives multiply it by up to 10^12
        .layout = onePiece,
    });
}

} // namespace splineloft::families
