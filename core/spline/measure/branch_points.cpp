#include "core/spline/measure/branch_points.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace splineloft {
namespace {

// The error of 16 points on [-1, 1] for |x - z| is at most 0.024 rho^-32 (measured over all z with
// 1 < rho < 3). The other factor of the speed may add to it.
constexpr double errorOfUnitKink = 0.05;
// A panel that ends beside a branch point at height y errs by at most 7 y^2 (measured, y > 1e-8),
// even if it is far longer: so close to the line, the speed is as good as a true corner.
constexpr double errorBesideCorner = 7;

/// An ellipse about [-1, 1] with foci at the ends: x^2 / A^2 + y^2 / B^2 = 1.
struct Ellipse {
    double overA2 = 0, overB2 = 0;
    double rest = 0, overRest = 0; ///< 1 - 1 / A^2, and one divided by it
};

/// Entry e is the ellipse of rho = 2^((e + 1) / 32), which lessens errors by 2^-(e + 1).
constexpr auto ellipses = [] {
    constexpr double rhoOfOneBit = 1.0218971486541166;
    std::array<Ellipse, 64> result{};
    double rho = rhoOfOneBit;
    for (auto& ellipse : result) {
        const double a = 0.5 * (rho + 1 / rho);
        const double b = 0.5 * (rho - 1 / rho);
        const double rest = 1 - 1 / (a * a);
        ellipse = {1 / (a * a), 1 / (b * b), rest, 1 / rest};
        rho *= rhoOfOneBit;
    }
    return result;
}();

/// The entry that lessens errors by `ratio`, which is above 1, or a little more.
std::size_t entryFor(double ratio) {
    constexpr std::uint64_t bitsOfMantissa = 52, exponentOfOne = 1023;
    const auto entry = (std::bit_cast<std::uint64_t>(ratio) >> bitsOfMantissa) - exponentOfOne;
    return std::min<std::size_t>(entry, ellipses.size() - 1);
}

} // namespace

BranchPoints::BranchPoints(std::complex<double> a, std::complex<double> b, std::complex<double> c) {
    using Complex = std::complex<double>;
    // Written out, for the library's product looks after infinities at a price.
    const auto times = [](Complex x, Complex y) {
        return Complex(x.real() * y.real() - x.imag() * y.imag(),
                       x.real() * y.imag() + x.imag() * y.real());
    };
    const auto over = [&](Complex x, Complex y) {
        const double scale = 1 / std::norm(y);
        return times(x, Complex(y.real() * scale, -y.imag() * scale));
    };
    const Complex square = times(b, b) - 4.0 * times(a, c);
    const double size = std::sqrt(std::norm(square));
    const double real = std::sqrt(0.5 * (size + std::abs(square.real())));
    const double other = real > 0 ? 0.5 * square.imag() / real : 0;
    Complex root = square.real() >= 0 ? Complex(real, other) : Complex(std::abs(other), real);
    if (square.real() < 0 && square.imag() < 0) {
        root = -std::conj(root);
    }
    // The sum that does not cancel.
    const bool along = b.real() * root.real() + b.imag() * root.imag() >= 0;
    const Complex sum = -0.5 * (along ? b + root : b - root);
    if (std::norm(c) > 0) {
        add(over(sum, c));
    }
    if (std::norm(sum) > 0) {
        add(over(a, sum));
    }
    const auto aboutSize = [](Complex x) { return std::abs(x.real()) + std::abs(x.imag()); };
    strength_ = aboutSize(root);
    if (count_ == 2) {
        const double apart = std::abs(points_[0].u - points_[1].u);
        strength_ = aboutSize(c) * (apart + points_[0].height + points_[1].height);
    }
}

void BranchPoints::add(std::complex<double> root) {
    constexpr double far = 100; // from there nothing is felt
    if (std::abs(root.real()) < far && std::abs(root.imag()) < far) {
        points_[count_++] = {root.real(), std::abs(root.imag())};
    }
}

double BranchPoints::panelEnd(double start, double tolerance) const {
    const double half = 0.5 * (1 - start);
    double widest = half;
    double corner = 1;
    for (std::size_t i = 0; i < count_; ++i) {
        const double ahead = points_[i].u - start;
        const double height = points_[i].height;
        if (errorBesideCorner * strength_ * height * height <= 0.5 * tolerance) {
            corner = ahead > 0 ? std::min(corner, points_[i].u) : corner;
            continue;
        }
        // No panel grows wider than this; and the smaller a panel, the fewer bits it has to lose.
        const double most = std::min(half, 4 * (std::abs(ahead) + height));
        const double ratio = errorOfUnitKink * strength_ * most * most;
        if (ratio <= tolerance) {
            widest = std::min(widest, most);
            continue;
        }
        // The half width h of the panel whose ellipse passes through the point:
        // (ahead - h)^2 / A^2 + height^2 / B^2 = h^2.
        const auto& ellipse = ellipses[entryFor(ratio / tolerance)];
        const double slope = ahead * ellipse.overA2;
        const double off = ahead * slope + height * height * ellipse.overB2;
        const double reach = std::sqrt(slope * slope + ellipse.rest * off) - slope;
        widest = std::min({widest, most, reach * ellipse.overRest});
    }
    const double end = widest < half ? start + 2 * widest : 1;
    return std::min(corner, end > start ? end : 1);
}

} // namespace splineloft
