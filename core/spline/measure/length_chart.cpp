#include "core/spline/measure/length_chart.h"

#include <algorithm>
#include <array>
#include <tuple>
#include <utility>

namespace splineloft {
namespace {

using lanes::EightByEight;

constexpr std::size_t half = gauss::count / 2;
static_assert(gauss::count == lanes::LengthSeries::count &&
              half == std::tuple_size_v<lanes::Eight>);

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

/// Of the pairs, one a column, the Legendre coefficients of the orders 2 i + parity in row i.
constexpr EightByEight legendreCoefficients(std::size_t parity) {
    EightByEight result{};
    for (std::size_t pair = 0; pair < gauss::pairs; ++pair) {
        for (std::size_t i = 0; i < half; ++i) {
            result[pair][i] = gauss::legendre[2 * i + parity][pair];
        }
    }
    return result;
}

constexpr lanes::PowerTables tables = {legendreCoefficients(0), legendrePowers(0),
                                       legendreCoefficients(1), legendrePowers(1)};

/// Values of a polynomial at -1 and 1.
template <std::size_t n> std::pair<double, double> endsOf(const std::array<double, n>& powers) {
    double even = 0, odd = 0;
    for (std::size_t j = 0; j < n; ++j) {
        (j % 2 == 0 ? even : odd) += powers[j];
    }
    return {even - odd, even + odd};
}

} // namespace

LengthChart::LengthChart(const gauss::Samples& speeds, const gauss::Spectrum& spectrum) {
    lanes::integrateSpeeds(tables, spectrum.sums(), spectrum.differences(), series_);
    series_.middle = -endsOf(series_.lengths).first;
    series_.lengths[0] = series_.middle;
    series_.whole = gauss::integralOf(speeds);
    prepareStart();
}

void LengthChart::prepareStart() {
    constexpr double slowest = 0.1; // of the mean speed
    const auto& [lengths, speeds, start, middle, whole] = series_;
    const auto [before, after] = endsOf(speeds);
    const double least = std::min({before, speeds[0], after});
    invertible_ = least > slowest * 0.5 * whole && middle > 0 && middle < whole;
    if (!invertible_) {
        return;
    }
    const std::array<double, 6> at = {0, 0, middle, middle, whole, whole};
    const std::array<double, 6> slope = {1 / before, 0, 1 / speeds[0], 0, 1 / after, 0};
    std::array<double, 6> differences = {-1, -1, 0, 0, 1, 1};
    for (std::size_t order = 1; order < at.size(); ++order) {
        for (std::size_t i = at.size() - 1; i >= order; --i) {
            const double gap = at[i] - at[i - order];
            differences[i] =
                gap > 0 ? (differences[i] - differences[i - 1]) / gap : slope[i - order];
        }
    }
    series_.start = differences;
}

} // namespace splineloft
