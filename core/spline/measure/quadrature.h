// Gauss quadrature on one panel, and what its samples tell of their own error.
//
// Sixteen samples give not only the integral but the first sixteen coefficients of the integrand's
// Legendre series. For a smooth integrand these fall geometrically, as fast as its nearest complex
// singularity lies far away, and the error of the integral is about the coefficient twice as far
// along (Trefethen 2008, "Is Gauss Quadrature Better than Clenshaw-Curtis?"). So a panel says by
// itself whether it is good, without a second look at halves of it.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace splineloft::gauss {

/// Samples lie in pairs, at +x and -x.
inline constexpr std::size_t pairs = 8;
inline constexpr std::size_t count = 2 * pairs;

/// One number a pair.
using Pairs = std::array<double, pairs>;

// 16-point Gauss-Legendre rule on [-1, 1]: the positive nodes and their weights
// (Abramowitz and Stegun 1964, table 25.4).
inline constexpr Pairs nodes = {
    0.0950125098376374401853193354249581, 0.2816035507792589132304605014604961,
    0.4580167776572273863424194429835776, 0.6178762444026437484466717640487911,
    0.7554044083550030338951011948474422, 0.8656312023878317438804678977123931,
    0.9445750230732325760779884155346083, 0.9894009349916499325961541734503326};
inline constexpr Pairs weights = {
    0.1894506104550684962853967232082831, 0.1826034150449235888667636679692199,
    0.1691565193950025381893120790303600, 0.1495959888165767320815017305474786,
    0.1246289712555338720524762821920164, 0.0951585116824927848099251076022462,
    0.0622535239386478928628438369943776, 0.0271524594117540948517805724560181};

namespace detail {

constexpr std::array<Pairs, count> legendreRows() {
    std::array<Pairs, count> rows{};
    for (std::size_t i = 0; i < pairs; ++i) {
        double before = 0; // Bonnet's recursion for the Legendre polynomials
        double here = 1;
        for (std::size_t k = 0; k < count; ++k) {
            const auto order = static_cast<double>(k);
            rows[k][i] = (2 * order + 1) / 2 * weights[i] * here;
            const double next = ((2 * order + 1) * nodes[i] * here - order * before) / (order + 1);
            before = here;
            here = next;
        }
    }
    return rows;
}

constexpr Pairs squaredNodes() {
    Pairs squares{};
    for (std::size_t i = 0; i < pairs; ++i) {
        squares[i] = nodes[i] * nodes[i];
    }
    return squares;
}

} // namespace detail

/// Row k times the sums (k even) or differences (k odd) of the pairs is Legendre coefficient k.
inline constexpr std::array<Pairs, count> legendre = detail::legendreRows();
inline constexpr Pairs squaredNodes = detail::squaredNodes();

/// What a function is at the nodes of [-1, 1].
struct Samples {
    Pairs after;  ///< at +x
    Pairs before; ///< at -x
};

/// The integral over [-1, 1] of what was sampled.
inline double integralOf(const Samples& samples) {
    double even = 0, odd = 0;
    for (std::size_t i = 0; i < pairs; i += 2) {
        even += weights[i] * (samples.after[i] + samples.before[i]);
        odd += weights[i + 1] * (samples.after[i + 1] + samples.before[i + 1]);
    }
    return even + odd;
}

/// The Legendre series of what was sampled: coefficients 0 to 15.
class Spectrum {
  public:
    explicit Spectrum(const Samples& samples) {
        for (std::size_t i = 0; i < pairs; ++i) {
            sums_[i] = samples.after[i] + samples.before[i];
            differences_[i] = samples.after[i] - samples.before[i];
        }
    }

    /// Of what was sampled, after + before and after - before.
    const Pairs& sums() const { return sums_; }
    const Pairs& differences() const { return differences_; }

    /// Coefficient k of the Legendre series, k from 0 to 15.
    template <std::size_t k> double coefficient() const {
        const auto& row = legendre[k];
        const auto& values = k % 2 == 0 ? sums_ : differences_;
        double even = 0, odd = 0;
        for (std::size_t i = 0; i < pairs; i += 2) {
            even += row[i] * values[i];
            odd += row[i + 1] * values[i + 1];
        }
        return even + odd;
    }

    /// Size of the last coefficients: the error of the series between the nodes.
    double tail() const { return largest(coefficient<13>(), coefficient<14>(), coefficient<15>()); }

    /// Estimate of the integral's error, on the safe side: the fall from coefficients 5, 6, 7 to
    /// 13, 14, 15 goes on for twice as long, of which it takes half. (Three of each, because single
    /// ones may vanish by chance or symmetry.)
    double error() const {
        const double late = tail();
        const double early = largest(coefficient<5>(), coefficient<6>(), coefficient<7>());
        return early > late ? late * (late / early) : late;
    }

  private:
    static double largest(double a, double b, double c) {
        return std::max({std::abs(a), std::abs(b), std::abs(c)});
    }

    Pairs sums_;
    Pairs differences_;
};

} // namespace splineloft::gauss
