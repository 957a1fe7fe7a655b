#include "core/spline/roots.h"

#include "core/spline/bernstein.h"
#include "core/spline/ladder.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace splineloft {
namespace {

// Halvings in a row: a double has no more bits to tell zeros apart.
constexpr int deepest = 54;

/// One search in one polynomial.
class Search {
  public:
    explicit Search(std::span<const double> coefficients)
        : whole_(coefficients.begin(), coefficients.end()) {
        double largest = 0;
        for (const double c : coefficients) {
            largest = std::max(largest, std::abs(c));
        }
        noise_ = largest * static_cast<double>(coefficients.size()) *
                 std::numeric_limits<double>::epsilon();
        if (largest > 0 && std::isfinite(largest)) {
            cut(whole_, 0, 1, 0);
        }
    }

    std::vector<double> take() { return std::move(roots_); }

  private:
    void add(double root) {
        if (roots_.empty() || root > roots_.back()) {
            roots_.push_back(root);
        }
    }

    int signOf(double value) const { return value > noise_ ? 1 : value < -noise_ ? -1 : 0; }

    int changesOf(std::span<const double> coefficients) const {
        int last = 0;
        int changes = 0;
        for (const double c : coefficients) {
            const int sign = signOf(c);
            changes += sign * last < 0 ? 1 : 0;
            last = sign != 0 ? sign : last;
        }
        return changes;
    }

    void cut(std::vector<double> coefficients, double low, double high, int depth) {
        if (signOf(coefficients.front()) == 0) {
            add(low);
        }
        const int changes = changesOf(coefficients);
        if (changes == 1) {
            add(bisected(low, high, signOf(coefficients.front()), signOf(coefficients.back())));
        } else if (changes > 1 && depth < deepest) {
            std::vector<double> left;
            for (auto rungs = std::span(coefficients); !rungs.empty();
                 rungs = rungs.first(rungs.size() - 1)) {
                left.push_back(rungs.front());
                climb(rungs, 0.5);
            }
            const double middle = 0.5 * (low + high);
            cut(std::move(left), low, middle, depth + 1);
            cut(coefficients, middle, high, depth + 1);
        }
        if (signOf(coefficients.back()) == 0 && high == 1) {
            add(high);
        }
    }

    /// The one change of sign between two parameter values, to the last bit.
    double bisected(double low, double high, int signBefore, int signAfter) const {
        const bool rises = signBefore < 0 || (signBefore == 0 && signAfter > 0);
        for (double middle = 0.5 * (low + high); low < middle && middle < high;
             middle = 0.5 * (low + high)) {
            const bool before = (valueAt(whole_, middle) < 0) == rises;
            (before ? low : high) = middle;
        }
        return 0.5 * (low + high);
    }

    std::vector<double> whole_;
    std::vector<double> roots_;
    double noise_ = 0;
};

} // namespace

std::vector<double> rootsOf(std::span<const double> coefficients) {
    return coefficients.size() < 2 ? std::vector<double>() : Search(coefficients).take();
}

} // namespace splineloft
