// From lengths back to spots, on one panel on which the quadrature of the speed has converged.
#pragma once

#include "core/spline/algebra/scale.h"
#include "core/spline/measure/length_chart.h"
#include "core/spline/measure/speed.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

namespace splineloft {

/// The parameter at `wanted` units of length beyond the start of a panel: Newton's method on the
/// length, between bounds that close in from both sides. `whole` is the length of the panel.
template <SpeedAlongPiece Speed>
double parameterAt(const Speed& speed, Stretch panel, double wanted, double whole) {
    constexpr int mostSteps = 60;
    double low = panel.start;
    double high = panel.end;
    double u = lerp(low, high, whole > 0 ? std::clamp(wanted / whole, 0.0, 1.0) : 1);
    for (int step = 0; step < mostSteps; ++step) {
        const double excess = integral(speed, panel.start, u) - wanted;
        const double rate = speed.at(u);
        // Where the next step would be rounding, u is found. (It might leave the bounds, though.)
        if (std::abs(excess) <= epsilon * std::max(speed.grain(u) * rate, whole)) {
            break;
        }
        (excess > 0 ? high : low) = u;
        const double next = rate > 0 ? u - excess / rate : low;
        u = next > low && next < high ? next : 0.5 * (low + high);
        if (!(low < u && u < high)) {
            break;
        }
    }
    return u;
}

/// Finds many lengths on one panel: with charts where several are close together, else one by one.
template <SpeedAlongPiece Speed> class Walk {
  public:
    /// Charts may be off by `tolerance`, which is a length.
    Walk(const Speed& speed, double tolerance)
        : speed_(speed), tolerance_(tolerance / speed.unit()) {}

    /// Puts in the place of `lengths`, which never fall and lie on the panel, which begins at
    /// `before`, the parameters where the curve reaches them.
    void along(Stretch panel, double before, std::span<double> lengths) const {
        along(panel, before, samplesOn(panel), lengths, 0);
    }

  private:
    static constexpr std::size_t fewest = 5; // that pay for a chart
    static constexpr int deepest = 40;       // halvings of a panel

    static double half(Stretch s) { return 0.5 * (s.end - s.start); }
    static double middle(Stretch s) { return 0.5 * (s.start + s.end); }
    gauss::Samples samplesOn(Stretch s) const { return speed_.on(middle(s), half(s)); }

    void along(Stretch here, double before, const gauss::Samples& samples,
               std::span<double> lengths, int depth) const {
        if (lengths.empty()) {
            return;
        }
        if (lengths.size() < fewest || depth == deepest) {
            oneByOne(here, before, half(here) * gauss::integralOf(samples), lengths);
            return;
        }
        const gauss::Spectrum spectrum(samples);
        const bool isSmooth = half(here) * LengthChart::errorOf(spectrum) <= tolerance_;
        if (isSmooth && byChart(LengthChart(spectrum), here, before, lengths)) {
            return;
        }
        const Stretch left{here.start, middle(here)};
        const Stretch right{middle(here), here.end};
        const auto onLeft = samplesOn(left);
        const double between = before + speed_.unit() * half(left) * gauss::integralOf(onLeft);
        const auto count =
            static_cast<std::size_t>(std::ranges::upper_bound(lengths, between) - lengths.begin());
        along(left, before, onLeft, lengths.first(count), depth + 1);
        if (count < lengths.size()) {
            along(right, between, samplesOn(right), lengths.subspan(count), depth + 1);
        }
    }

    void oneByOne(Stretch here, double before, double whole, std::span<double> lengths) const {
        for (auto& length : lengths) {
            const double wanted = (length - before) / speed_.unit();
            length = parameterAt(speed_, here, wanted, whole);
        }
    }

    /// Not where the chart cannot be inverted.
    bool byChart(const LengthChart& chart, Stretch here, double before,
                 std::span<double> lengths) const {
        if (!chart.isInvertible()) {
            return false;
        }
        chart.invert({before, 1 / (speed_.unit() * half(here)), here.start, here.end}, lengths);
        return true;
    }

    const Speed& speed_;
    double tolerance_;
};

} // namespace splineloft
