// The search for the spot of one piece nearest to a place: exact, by branch and bound.
//
// With the place at the origin, the squared distance and the pull, which is half its derivative,
// are polynomials of the piece's Bézier points. In Bernstein form their coefficients bound them:
// the squared distance is nowhere below its least coefficient, and the pull changes sign no more
// often than its coefficients do (Farin and Farouki 2012). Where the pull changes sign once, there
// is one minimum, found by Newton's method between bounds; where more often, the piece is cut in
// half, unless the bound says that nothing nearer than the best spot so far is to be found.
#pragma once

#include "core/spline/piece.h"

#include <cmath>
#include <cstddef>
#include <span>

namespace splineloft::nearest {

/// The best spot so far: the first on the curve of those equally near.
class Best {
  public:
    /// Only what is nearer than `within` counts. `within` and all measures offered are distances,
    /// or all are squares of such.
    explicit Best(double within) : measure_(within) {}

    bool isFound() const { return found_; }
    Spot spot() const { return spot_; }
    double measure() const { return measure_; }
    /// Nothing as far away as this is wanted.
    bool rules(double lowerBound) const { return lowerBound > measure_; }

    void offer(std::size_t segment, double u, double measure) {
        const bool isEarlier = segment < spot_.segment || (segment == spot_.segment && u < spot_.u);
        if (measure < measure_ || (found_ && measure == measure_ && isEarlier)) {
            measure_ = measure;
            spot_ = {segment, u};
            found_ = true;
        }
    }

  private:
    Spot spot_;
    double measure_;
    bool found_ = false;
};

/// How often Bernstein coefficients change sign, and how sure that is.
class Signs {
  public:
    /// Coefficients up to `noise` in size may be rounding.
    Signs(std::span<const double> coefficients, double noise) {
        std::size_t last = 0; // the last one of which the sign is known
        double sign = 0;
        for (std::size_t k = 0; k < coefficients.size(); ++k) {
            const double c = coefficients[k];
            if (std::abs(c) <= noise) {
                uncertain_ = uncertain_ || c != 0;
                continue;
            }
            if (c * sign < 0) {
                ++changes_;
                rises_ = c > 0;
                const double part = coefficients[last] / (coefficients[last] - c);
                crossing_ = (static_cast<double>(last) + part * static_cast<double>(k - last)) /
                            static_cast<double>(coefficients.size() - 1);
            }
            last = k;
            sign = c > 0 ? 1 : -1;
        }
    }

    /// The function has no minimum between its ends.
    bool haveNoMinimum() const {
        return !uncertain_ && (changes_ == 0 || (changes_ == 1 && !rises_));
    }
    /// It has exactly one, where its derivative's coefficients change sign.
    bool haveOneMinimum() const { return !uncertain_ && changes_ == 1 && rises_; }
    /// Where the coefficients' polygon crosses zero for the last time: near a zero. In the middle
    /// if nowhere.
    double crossing() const { return crossing_; }

  private:
    int changes_ = 0;
    bool rises_ = false;     // at the last change
    bool uncertain_ = false; // some coefficients may be rounding
    double crossing_ = 0.5;
};

// Cuts of one piece. Enough for every minimum of any ordinary piece; reached only where the
// distance hardly changes, as around the center of an arc.
inline constexpr int mostCuts = 512;
// Gains below this part of a squared distance are rounding.
inline constexpr double gain = 8e-15;

/// Where a rising function of t in [0, 1] is zero: Newton's method from `t`, between bounds that
/// close in. `at(t)` gives its value, slope and noise.
template <class At> double risingZero(At at, double t) {
    constexpr double enough = 1e-12; // a step of Newton's after which the error is its square
    constexpr double exact = 1e-16;
    constexpr int mostSteps = 100;
    double low = 0;
    double high = 1;
    double before = 0; // the last step, if it was Newton's
    for (int step = 0; step < mostSteps; ++step) {
        const auto [value, slope, noise] = at(t);
        if (std::abs(value) <= noise) {
            return t;
        }
        (value < 0 ? low : high) = t;
        const double next = t - value / slope;
        if (slope > 0 && next > low && next < high) {
            // A step leaves its square times a factor, which the step before has shown.
            const double length = std::abs(next - t);
            if (length < enough || length * length * length < exact * before * before) {
                return next;
            }
            before = length;
            t = next;
        } else {
            before = 0;
            t = 0.5 * (low + high);
            if (!(low < t && t < high)) {
                return t;
            }
        }
    }
    return t;
}

/// Value, slope and rounding of a function.
struct Zeroing {
    double value, slope, noise;
};

} // namespace splineloft::nearest
