// The nearest search on polynomial pieces of low degree in few dimensions: no allocation, and all
// loops of known length. Same method as in nearest_any.h.
#pragma once

#include "core/spline/measure/nearest_search.h"

#include <algorithm>
#include <array>
#include <limits>

namespace splineloft::nearest {

/// Coordinates whose squares, and those of their differences, are ordinary numbers, lie between.
inline constexpr double leastQuick = 0x1p-250;
inline constexpr double mostQuick = 0x1p250;

/// Measures are squared distances.
template <std::size_t dimension, std::size_t degree> class CubicSearch {
  public:
    CubicSearch(const Pieces& pieces, const Point& place, double within)
        : points_(pieces.bezier().data()), best_(within * within) {
        std::ranges::copy(place.coordinates(), place_.begin());
    }

    const Best& best() const { return best_; }
    double distance() const { return std::sqrt(best_.measure()); }

    /// Lower bound of the squared distance: that of the Bézier points' box.
    double bound(std::size_t segment) const {
        const double* const p = points_ + segment * numbers;
        double sum = 0;
        for (std::size_t c = 0; c < dimension; ++c) {
            double low = p[c];
            double high = low;
            for (std::size_t i = 1; i <= degree; ++i) {
                low = std::min(low, p[i * dimension + c]);
                high = std::max(high, p[i * dimension + c]);
            }
            const double outside = std::max(std::max(low - place_[c], place_[c] - high), 0.0);
            sum += outside * outside;
        }
        return sum * (1 - 8 * epsilon);
    }

    /// Searches one piece.
    void look(std::size_t segment) {
        segment_ = segment;
        cuts_ = 0;
        const double* const p = points_ + segment * numbers;
        Part part;
        for (std::size_t i = 0; i <= degree; ++i) {
            for (std::size_t c = 0; c < dimension; ++c) {
                part.ways[i][c] = p[i * dimension + c] - place_[c];
            }
        }
        best_.offer(segment, 0, square(part.ways.front()));
        best_.offer(segment, 1, square(part.ways.back()));
        branch(part);
    }

  private:
    using Vector = std::array<double, dimension>;

    /// A part of the piece, as seen from the place.
    struct Part {
        std::array<Vector, degree + 1> ways; ///< to its Bézier points
        double low = 0, high = 1;            ///< values of u
    };

    static constexpr std::size_t numbers = (degree + 1) * dimension;
    static constexpr double epsilon = std::numeric_limits<double>::epsilon();

    static double times(const Vector& a, const Vector& b) {
        double sum = 0;
        for (std::size_t c = 0; c < dimension; ++c) {
            sum += a[c] * b[c];
        }
        return sum;
    }
    static double square(const Vector& a) { return times(a, a); }

    static constexpr double binomial(std::size_t n, std::size_t k) {
        double result = 1;
        for (std::size_t i = 1; i <= k; ++i) {
            result = result * static_cast<double>(n - k + i) / static_cast<double>(i);
        }
        return result;
    }

    /// Shares of the products of coefficients i and j, of degrees `degree` and n, in i + j.
    template <std::size_t n> static constexpr auto sharesWith() {
        std::array<std::array<double, n + 1>, degree + 1> shares{};
        for (std::size_t i = 0; i <= degree; ++i) {
            for (std::size_t j = 0; j <= n; ++j) {
                shares[i][j] = binomial(degree, i) * binomial(n, j) / binomial(degree + n, i + j);
            }
        }
        return shares;
    }

    /// Bernstein coefficients of the squared distance are at least this.
    static double leastSquare(const Part& part) {
        static constexpr auto shares = sharesWith<degree>();
        std::array<double, 2 * degree + 1> squares{};
        for (std::size_t i = 0; i <= degree; ++i) {
            for (std::size_t j = 0; j <= degree; ++j) {
                squares[i + j] += shares[i][j] * times(part.ways[i], part.ways[j]);
            }
        }
        return *std::ranges::min_element(squares);
    }

    void branch(const Part& part) {
        static constexpr auto shares = sharesWith<degree - 1>();
        std::array<Vector, degree> legs;
        double farthest = std::abs(part.ways[degree][0]);
        double longest = 0;
        for (std::size_t i = 0; i < degree; ++i) {
            for (std::size_t c = 0; c < dimension; ++c) {
                legs[i][c] = part.ways[i + 1][c] - part.ways[i][c];
                farthest = std::max(farthest, std::abs(part.ways[i][c]));
                longest = std::max(longest, std::abs(legs[i][c]));
            }
        }
        for (const double x : part.ways[degree]) {
            farthest = std::max(farthest, std::abs(x));
        }
        std::array<double, 2 * degree> pull{};
        for (std::size_t i = 0; i <= degree; ++i) {
            for (std::size_t j = 0; j < degree; ++j) {
                pull[i + j] += shares[i][j] * times(part.ways[i], legs[j]);
            }
        }
        const double noise =
            8 * static_cast<double>(degree * dimension) * epsilon * farthest * longest;
        const Signs signs(pull, noise);
        if (signs.haveNoMinimum()) {
            return;
        }
        if (signs.haveOneMinimum()) {
            settle(part, legs, signs.crossing());
        } else if (!(leastSquare(part) >= best_.measure() * (1 - gain))) {
            cut(part, legs, signs.crossing());
        }
    }

    /// The minimum of a part, near t = start.
    void settle(const Part& part, const std::array<Vector, degree>& legs, double start) {
        // Powers of t, of the way and of its derivative.
        std::array<Vector, degree + 1> powers;
        powers[0] = part.ways[0];
        std::array<Vector, degree> differences = legs;
        for (std::size_t k = 1; k <= degree; ++k) {
            for (std::size_t c = 0; c < dimension; ++c) {
                powers[k][c] = binomial(degree, k) * differences[0][c];
            }
            for (std::size_t i = 0; i + k < degree; ++i) {
                for (std::size_t c = 0; c < dimension; ++c) {
                    differences[i][c] = differences[i + 1][c] - differences[i][c];
                }
            }
        }
        Vector way{};
        const auto at = [&](double t) {
            double value = 0, slope = 0, sizes = 0;
            for (std::size_t c = 0; c < dimension; ++c) {
                double w = powers[degree][c], first = 0, half = 0; // half the second derivative
                for (std::size_t k = degree; k-- > 0;) {
                    half = half * t + first;
                    first = first * t + w;
                    w = w * t + powers[k][c];
                }
                value += w * first;
                slope += first * first + 2 * w * half;
                sizes += std::abs(w * first);
                way[c] = w;
            }
            return Zeroing{value, slope, 2 * epsilon * sizes};
        };
        const double t = risingZero(at, start);
        at(t);
        best_.offer(segment_, part.low + t * (part.high - part.low), square(way));
    }

    void cut(const Part& part, const std::array<Vector, degree>& legs, double crossing) {
        const double middle = 0.5 * (part.low + part.high);
        if (cuts_ == mostCuts || !(part.low < middle && middle < part.high)) {
            settle(part, legs, crossing);
            return;
        }
        ++cuts_;
        Part left{part.ways, part.low, middle};
        Part right{part.ways, middle, part.high};
        for (std::size_t level = 1; level <= degree; ++level) {
            for (std::size_t i = 0; i + level <= degree; ++i) {
                for (std::size_t c = 0; c < dimension; ++c) {
                    right.ways[i][c] = 0.5 * (right.ways[i][c] + right.ways[i + 1][c]);
                }
            }
            left.ways[level] = right.ways[0];
        }
        best_.offer(segment_, middle, square(right.ways[0]));
        branch(left);
        branch(right);
    }

    const double* points_;
    Vector place_{};
    Best best_;
    std::size_t segment_ = 0;
    int cuts_ = 0;
};

} // namespace splineloft::nearest
