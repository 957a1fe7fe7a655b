#include "core/spline/measure/length_chart.h"

#include <algorithm>
#include <array>
#include <tuple>

namespace splineloft {
namespace {

using lanes::EightByEight;

constexpr std::size_t half = gauss::count / 2;
static_assert(half == std::tuple_size_v<lanes::Eight>);

/// Powers of x in the Legendre polynomials of even order (parity 0), which has even powers only, or
/// of odd order (parity 1): column i belongs to order 2 i + parity, row j to x^(2 j + parity).
constexpr EightByEight legendrePowers(std::size_t parity) {
    std::array<std::array<double, gauss::count>, gauss::count> orders{};
    orders[0][0] = 1;
    orders[1][1] = 1;
    for (std::size_t k = 1; k + 1 < gauss::count; ++k) {
        const auto order = static_cast<double>(k);
        for (std::size_t j = 0; j <= k + 1; ++j) {
            const double raised = j > 0 ? (2 * order + 1) * orders[k][j - 1] : 0;
            orders[k + 1][j] = (raised - order * orders[k - 1][j]) / (order + 1);
        }
    }
    EightByEight result{};
    for (std::size_t i = 0; i < half; ++i) {
        for (std::size_t j = 0; j < half; ++j) {
            result[i][j] = orders[2 * i + parity][2 * j + parity];
        }
    }
    return result;
}

constexpr auto evenPowers = legendrePowers(0);
constexpr auto oddPowers = legendrePowers(1);

} // namespace

LengthChart::LengthChart(const gauss::Spectrum& speeds) {
    prepareStart(
        lanes::integrateSeries(evenPowers, oddPowers, speeds.even(), speeds.odd(), series_));
}

void LengthChart::prepareStart(const lanes::EndSpeeds& ends) {
    constexpr double slowest = 0.1; // of the mean speed
    const double middle = series_.middle, whole = series_.whole;
    const double least = std::min({ends.before, series_.evenSpeed[0], ends.after});
    invertible_ = least > slowest * 0.5 * whole && middle > 0 && middle < whole;
    if (!invertible_) {
        return;
    }
    // Differences of x, which is -1, 0 and 1 at 0, middle and whole, each of these taken twice.
    const double overLeft = 1 / middle, overRight = 1 / (whole - middle), overWhole = 1 / whole;
    const double atLeft = 1 / ends.before, at0 = 1 / series_.evenSpeed[0], atRight = 1 / ends.after;
    const double left2 = (overLeft - atLeft) * overLeft; // over 0, 0, middle
    const double left2b = (at0 - overLeft) * overLeft;   // over 0, middle, middle
    const double right2 = (overRight - at0) * overRight;
    const double right2b = (atRight - overRight) * overRight;
    const double left3 = (left2b - left2) * overLeft;
    const double across3 = (right2 - left2b) * overWhole;
    const double right3 = (right2b - right2) * overRight;
    const double left4 = (across3 - left3) * overWhole;
    const double right4 = (right3 - across3) * overWhole;
    series_.start = {-1, atLeft, left2, left3, left4, (right4 - left4) * overWhole};
}

} // namespace splineloft
