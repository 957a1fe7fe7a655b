// A chart of a short stretch of a piece: its length as a polynomial of the parameter, with which
// many spots are found quickly.
#pragma once

#include "core/spline/fast/lanes/chart_lanes.h"
#include "core/spline/measure/quadrature.h"

#include <span>

namespace splineloft {

/// Length s(x) from the start of a panel, -1 <= x <= 1: the integral of the polynomial through the
/// speed at the Gauss nodes. Its inverse starts from Hermite's interpolation of x(s) at the ends
/// and the middle, and ends with Newton's method.
class LengthChart {
  public:
    explicit LengthChart(const gauss::Spectrum& speeds);

    /// How far the charted lengths are off at most, about: the first coefficient left out is like
    /// the last ones left in, and integrates to 1 / 16 of itself.
    static double errorOf(const gauss::Spectrum& speeds) {
        return speeds.tail() / static_cast<double>(gauss::count);
    }
    /// Whether the speed varies so little that the inverse is sure to be found.
    bool isInvertible() const { return invertible_; }

    /// Puts in the place of lengths of the curve, which lie on the panel, the parameters where it
    /// reaches them.
    void invert(const lanes::PanelPlace& place, std::span<double> lengths) const {
        lanes::invertLengths(series_, place, lengths.data(), lengths.size());
    }

  private:
    void prepareStart(const lanes::EndSpeeds& ends);

    lanes::LengthSeries series_;
    bool invertible_ = false;
};

} // namespace splineloft
