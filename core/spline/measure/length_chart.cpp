#include "core/spline/measure/length_chart.h"

#include <algorithm>
#include <cmath>
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

Two bounded(Two x) {
    constexpr Two first = {-1, -1}, last = {1, 1};
    x = x > first ? x : first;
    return x < last ? x : last;
}

/// The larger of a size and the size of another number.
Two larger(Two size, Two other) {
    size = size > other ? size : other;
    return size > -other ? size : -other;
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

LengthChart::LengthChart(const gauss::Samples& speeds, const gauss::Spectrum& spectrum)
    : length_(gauss::integralOf(speeds)) {
    speeds_ = powersOf(spectrum, std::make_index_sequence<gauss::count>());
    for (std::size_t j = 0; j < gauss::count; ++j) {
        lengths_[j + 1] = speeds_[j] / static_cast<double>(j + 1);
    }
    middle_ = -endsOf(lengths_).first;
    lengths_[0] = middle_;
    prepareStart();
}

void LengthChart::prepareStart() {
    constexpr double slowest = 0.1; // of the mean speed
    const auto [before, after] = endsOf(speeds_);
    const double least = std::min({before, speeds_[0], after});
    invertible_ = least > slowest * 0.5 * length_ && middle_ > 0 && middle_ < length_;
    if (!invertible_) {
        return;
    }
    // Newton's divided differences over the lengths 0, 0, middle, middle, all, all.
    const std::array<double, 6> at = {0, 0, middle_, middle_, length_, length_};
    const std::array<double, 6> x = {-1, -1, 0, 0, 1, 1};
    const std::array<double, 6> slope = {1 / before, 0, 1 / speeds_[0], 0, 1 / after, 0};
    start_ = x;
    for (std::size_t order = 1; order < at.size(); ++order) {
        for (std::size_t i = at.size() - 1; i >= order; --i) {
            const double gap = at[i] - at[i - order];
            start_[i] = gap > 0 ? (start_[i] - start_[i - 1]) / gap : slope[i - order];
        }
    }
}

void LengthChart::invertBlock(std::array<double, block>& lengths) const {
    constexpr double enough = 3e-6; // a step of third order after which x is exact
    constexpr int mostSteps = 8;
    Lanes wanted, x;
    for (std::size_t i = 0; i < lanes; ++i) {
        wanted[i] = Two{lengths[2 * i], lengths[2 * i + 1]};
        const Two toMiddle = wanted[i] - middle_;
        const Two upper = start_[4] + (wanted[i] - length_) * start_[5];
        const Two inner = start_[2] + toMiddle * (start_[3] + toMiddle * upper);
        x[i] = bounded(start_[0] + wanted[i] * (start_[1] + wanted[i] * inner));
    }
    Lanes speedBefore{}, way{};
    for (int round = 0; round < mostSteps; ++round) {
        Lanes length, speed;
        evaluate(x, length, speed);
        Two most = {};
        for (std::size_t i = 0; i < lanes; ++i) {
            Two step = (wanted[i] - length[i]) / speed[i];
            most = larger(most, step);
            // The next term of the series, with the slope of the speed from its difference: what
            // is left is of third order.
            const Two slope = (speed[i] - speedBefore[i]) / way[i];
            const Two bent = step - 0.5 * step * step * slope / speed[i];
            step = way[i] != Two{} ? bent : step;
            const Two next = bounded(x[i] + step);
            speedBefore[i] = speed[i];
            way[i] = next - x[i];
            x[i] = next;
        }
        if (std::max(most[0], most[1]) < (round > 0 ? enough : enough * enough)) {
            break;
        }
    }
    for (std::size_t i = 0; i < block; ++i) {
        lengths[i] = x[i / 2][i % 2];
    }
}

/// Horner's scheme for the length and, one step behind, its derivative. Lanes lie side by side,
/// because each waits for itself.
void LengthChart::evaluate(const Lanes& x, Lanes& length, Lanes& speed) const {
    Lanes s, v;
    s.fill(Two{} + lengths_[gauss::count]);
    v.fill(Two{});
    for (std::size_t j = gauss::count; j-- > 0;) {
        for (std::size_t i = 0; i < lanes; ++i) {
            v[i] = v[i] * x[i] + s[i];
            s[i] = s[i] * x[i] + lengths_[j];
        }
    }
    length = s;
    speed = v;
}

void LengthChart::invert(std::span<double> lengths) const {
    for (std::size_t first = 0; first < lengths.size(); first += block) {
        const auto some = lengths.subspan(first, std::min(block, lengths.size() - first));
        std::array<double, block> together;
        together.fill(some[0]);
        std::ranges::copy(some, together.begin());
        invertBlock(together);
        std::copy_n(together.begin(), some.size(), some.begin());
    }
}

} // namespace splineloft
