#include "core/spline/algebra/bernstein.h"

#include "core/spline/ladder.h"

namespace splineloft {

// Bernstein polynomials number i and j of degrees m and n multiply to number i + j of degree m + n
// times binomial(m, i) binomial(n, j) / binomial(m + n, i + j), a ratio that goes from one j to the
// next, and from one i to the next, by a quotient of small whole numbers.
Bernstein product(std::span<const double> a, std::span<const double> b) {
    const auto m = static_cast<int>(a.size()) - 1;
    const auto n = static_cast<int>(b.size()) - 1;
    Bernstein result(static_cast<std::size_t>(m + n + 1));
    double first = 1; // the ratio for j = 0
    for (int i = 0; i <= m; ++i) {
        double ratio = first;
        for (int j = 0; j <= n; ++j) {
            result[static_cast<std::size_t>(i + j)] +=
                ratio * a[static_cast<std::size_t>(i)] * b[static_cast<std::size_t>(j)];
            if (j < n) {
                ratio *= static_cast<double>(n - j) / (j + 1) * (i + j + 1) / (m + n - i - j);
            }
        }
        if (i < m) {
            first *= static_cast<double>(m - i) / (m + n - i);
        }
    }
    return result;
}

Bernstein sum(std::span<const double> a, std::span<const double> b, double factor) {
    Bernstein result(a.begin(), a.end());
    for (std::size_t i = 0; i < result.size(); ++i) {
        result[i] += factor * b[i];
    }
    return result;
}

Bernstein derivative(std::span<const double> a) {
    if (a.size() < 2) {
        return {0};
    }
    Bernstein result;
    const auto degree = static_cast<double>(a.size() - 1);
    for (std::size_t i = 0; i + 1 < a.size(); ++i) {
        result.push_back(degree * (a[i + 1] - a[i]));
    }
    return result;
}

Bernstein elevated(std::span<const double> a, int degree) {
    Bernstein result(a.begin(), a.end());
    for (auto d = a.size(); d <= static_cast<std::size_t>(degree); ++d) {
        result.push_back(result.back());
        for (std::size_t k = d - 1; k > 0; --k) {
            const double share = static_cast<double>(k) / static_cast<double>(d);
            result[k] = share * result[k - 1] + (1 - share) * result[k];
        }
    }
    return result;
}

double valueAt(std::span<const double> a, double u) {
    Bernstein rungs(a.begin(), a.end());
    for (auto left = rungs.size(); left > 1; --left) {
        climb(std::span(rungs).first(left), u);
    }
    return rungs.front();
}

} // namespace splineloft
