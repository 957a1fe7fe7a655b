#include "core/spline/measure/length_chart.h"

#include <algorithm>
#include <array>
#include <utility>

namespace splineloft {
namespace {

using Powers = std::array<double, gauss::count>;

constexpr std::size_t half = gauss::count / 2;
using Square = std::array<std::array<double, half>, half>;

/// Powers of x in the Legendre polynomials of even order (parity 0), which has even powers only, or
/// of odd order (parity 1): row i belongs to order 2 i + parity, column j to x^(2 j + parity).
constexpr Square legendrePowers(std::size_t parity) {
    std::array<Powers, gauss::count> rows{};
    rows[0][0] = 1;
    rows[1][1] = 1;
    for (std::size_t k = 1; k + 1 < gauss::count; ++k) {
        const auto order = static_cast<double>(k);
        for (std::size_t j = 0; j <= k + 1; ++j) {
            const double raised = j > 0 ? (2 * order + 1) * rows[k][j - 1] : 0;
            rows[k + 1][j] = (raised - order * rows[k - 1][j]) / (order + 1);
        }
    }
    Square result{};
    for (std::size_t i = 0; i < half; ++i) {
        for (std::size_t j = 0; j < half; ++j) {
            result[i][j] = rows[2 * i + parity][2 * j + parity];
        }
    }
    return result;
}

constexpr Square evenPowers = legendrePowers(0);
constexpr Square oddPowers = legendrePowers(1);

template <std::size_t... k>
Powers powersOf(const gauss::Spectrum& spectrum, std::index_sequence<k...>) {
    const std::array coefficients = {spectrum.coefficient<k>()...};
    std::array<double, half> even{}, odd{};
    for (std::size_t i = 0; i < half; ++i) {
        for (std::size_t j = 0; j < half; ++j) {
            even[j] += coefficients[2 * i] * evenPowers[i][j];
            odd[j] += coefficients[2 * i + 1] * oddPowers[i][j];
        }
    }
    Powers powers;
    for (std::size_t j = 0; j < half; ++j) {
        powers[2 * j] = even[j];
        powers[2 * j + 1] = odd[j];
    }
    return powers;
}

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
    static_assert(lanes::LengthSeries::count == gauss::count);
    auto& [lengths, rates, start, middle, whole] = series_;
    rates = powersOf(spectrum, std::make_index_sequence<gauss::count>());
    for (std::size_t j = 0; j < gauss::count; ++j) {
        lengths[j + 1] = rates[j] / static_cast<double>(j + 1);
    }
    middle = -endsOf(lengths).first;
    lengths[0] = middle;
    whole = gauss::integralOf(speeds);
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
