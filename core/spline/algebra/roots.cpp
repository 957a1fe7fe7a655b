#include "core/spline/algebra/roots.h"

#include "core/spline/algebra/bernstein.h"
#include "core/spline/algebra/scale.h"
#include "core/spline/ladder.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace splineloft {
namespace {

// Halvings in a row: a double has no more bits to tell zeros apart.
constexpr int deepest = 54;
// Halvings altogether: far more than any zeros need, so that no input takes forever.
constexpr int mostCuts = 20'000;

/// One search in one polynomial.
class ZeroSearch {
  public:
    ZeroSearch(std::span<const double> coefficients, double rounding)
        : whole_(coefficients.begin(), coefficients.end()), rungs_(whole_.size()),
          rounding_(rounding) {
        const double largest = largestOf(whole_);
        if (largest > rounding && std::isfinite(largest)) {
            cut(whole_, 0, 1, 0);
        }
    }

    std::vector<double> take() {
        std::vector<double> roots;
        for (const auto& found : found_) {
            const double root = settled(0.5 * (found.low + found.high), found.high - found.low);
            if (roots.empty() || root > roots.back()) {
                roots.push_back(root);
            }
        }
        return roots;
    }

  private:
    /// Where the polynomial is zero, as far as rounding shows.
    struct Interval {
        double low, high;
    };

    void add(Interval interval) {
        if (!found_.empty() && interval.low <= found_.back().high) {
            found_.back().high = std::max(found_.back().high, interval.high);
        } else {
            found_.push_back(interval);
        }
    }

    int signOf(double value) const { return value > rounding_ ? 1 : value < -rounding_ ? -1 : 0; }

    void cut(std::vector<double> coefficients, double low, double high, int depth) {
        const auto isZero = [this](double c) { return signOf(c) == 0; };
        const auto first = std::ranges::find_if_not(coefficients, isZero);
        if (first == coefficients.end()) {
            add({low, high});
            return;
        }
        const auto last = std::find_if_not(coefficients.rbegin(), coefficients.rend(), isZero);
        const bool zeroAtHigh = last != coefficients.rbegin();
        if (first != coefficients.begin()) {
            add({low, low});
        }
        int sign = signOf(*first);
        int changes = 0;
        bool touching = false; // some coefficient between is zero
        for (auto at = first; at != last.base(); ++at) {
            changes += signOf(*at) * sign < 0 ? 1 : 0;
            touching = touching || isZero(*at);
            sign = isZero(*at) ? sign : signOf(*at);
        }
        if (changes == 1) {
            const double root = refined(low, high, sign > 0);
            add({root, root});
        } else if (changes > 1 || touching) {
            if (depth < deepest && cuts_ < mostCuts) {
                ++cuts_;
                const double middle = 0.5 * (low + high);
                cut(leftHalfOf(coefficients), low, middle, depth + 1);
                cut(coefficients, middle, high, depth + 1);
            } else {
                add({low, high});
            }
        }
        if (zeroAtHigh) {
            add({high, high});
        }
    }

    /// The left half; what was given becomes the right one.
    static std::vector<double> leftHalfOf(std::vector<double>& coefficients) {
        std::vector<double> left;
        left.reserve(coefficients.size());
        for (auto rungs = std::span(coefficients); !rungs.empty();
             rungs = rungs.first(rungs.size() - 1)) {
            left.push_back(rungs.front());
            climb(rungs, 0.5);
        }
        return left;
    }

    struct ValueAndSlope {
        double value, slope;
    };

    ValueAndSlope at(double u) {
        std::ranges::copy(whole_, rungs_.begin());
        for (auto left = rungs_.size(); left > 2; --left) {
            climb(std::span(rungs_).first(left), u);
        }
        const auto degree = static_cast<double>(whole_.size() - 1);
        return {lerp(rungs_[0], rungs_[1], u), degree * (rungs_[1] - rungs_[0])};
    }

    /// The one change of sign between two parameter values, to the last bit: by Newton's steps,
    /// and by halving where they leave the interval or do not shorten.
    double refined(double low, double high, bool rises) {
        double u = 0.5 * (low + high);
        double step = high - low;
        while (low < u && u < high) {
            const auto [value, slope] = at(u);
            if (value == 0) {
                return u;
            }
            ((value < 0) == rises ? low : high) = u;
            const double middle = 0.5 * (low + high);
            double next = u - value / slope;
            if (!(low < next && next < high) || !(std::abs(next - u) < 0.5 * step)) {
                // Standing still is arriving, but not where the slope is that of a zero farther on:
                // at the flat end of a polynomial that vanishes there to a high order.
                const bool arrived = next == u && (slope > 0) == rises;
                next = arrived ? u : middle;
            }
            step = std::abs(next - u);
            if (step == 0) {
                return u;
            }
            u = next;
        }
        return u;
    }

    /// The zero that was found at `u`, or within `width` around it. A double one, which shows as a
    /// whole interval of zeros or as two, is a simple zero of the derivative, which can be seen
    /// exactly; one of higher order is so of a higher derivative.
    double settled(double u, double width) {
        constexpr double exactly = 1e-10;
        if (width <= exactly && std::abs(at(u).slope) * exactly > rounding_) {
            return u;
        }
        if (!level_) {
            const Bernstein slope = derivative(whole_);
            level_ = rootsOf(slope, 2 * static_cast<double>(slope.size()) * rounding_);
        }
        double best = u;
        double least = 2; // distance, more than any
        for (const double level : *level_) {
            const bool allZero = isNearZero(level) && isNearZero(0.5 * (u + level));
            if (allZero && std::abs(level - u) < least) {
                best = level;
                least = std::abs(level - u);
            }
        }
        return best;
    }

    bool isNearZero(double u) { return std::abs(at(u).value) <= 2 * rounding_; }

    std::vector<double> whole_;
    std::vector<double> rungs_;
    std::vector<Interval> found_;
    std::optional<std::vector<double>> level_; // zeros of the derivative, once they are asked for
    double rounding_;
    int cuts_ = 0;
};

} // namespace

std::vector<double> rootsOf(std::span<const double> coefficients) {
    return rootsOf(coefficients, largestOf(coefficients) *
                                     static_cast<double>(coefficients.size()) *
                                     std::numeric_limits<double>::epsilon());
}

std::vector<double> rootsOf(std::span<const double> coefficients, double rounding) {
    if (coefficients.size() < 2 || !std::isfinite(rounding)) {
        return {};
    }
    Bernstein scaled(coefficients.begin(), coefficients.end());
    const double scale = scaleFor(largestOf(coefficients)); // slopes may overflow as they are
    std::ranges::transform(scaled, scaled.begin(), [=](double c) { return scale * c; });
    return ZeroSearch(scaled, scale * std::max(rounding, 0.0)).take();
}

} // namespace splineloft
