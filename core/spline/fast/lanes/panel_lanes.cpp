#include "core/spline/fast/lanes/panel_lanes.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/spline/fast/lanes/panel_lanes.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h, which compiles what follows several times.
#include <hwy/highway.h>

#ifndef SPLINELOFT_ELLIPSES
#define SPLINELOFT_ELLIPSES
namespace splineloft::lanes {
namespace {

/// An ellipse about [-1, 1] with foci at the ends: x^2 / A^2 + y^2 / B^2 = 1.
struct Ellipse {
    double overA2 = 0, overB2 = 0;
    double rest = 0, overRest = 0; ///< 1 - 1 / A^2, and one divided by it
};

/// Entry e is the ellipse of rho = 2^(e / 64), off which 32 points lessen errors by 2^-e, and 16 by
/// the root of that.
constexpr auto ellipses = [] {
    constexpr double rhoOfOneBit = 1.0108892860517004600;
    std::array<Ellipse, 129> result{};
    double rho = rhoOfOneBit;
    for (std::size_t e = 1; e < result.size(); ++e) {
        const double a = 0.5 * (rho + 1 / rho);
        const double b = 0.5 * (rho - 1 / rho);
        const double rest = 1 - 1 / (a * a);
        result[e] = {1 / (a * a), 1 / (b * b), rest, 1 / rest};
        rho *= rhoOfOneBit;
    }
    return result;
}();

} // namespace
} // namespace splineloft::lanes
#endif

HWY_BEFORE_NAMESPACE();
namespace splineloft::lanes::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

// The error of n points on [-1, 1] for |x - z| is at most 0.024 rho^(-2n) for n = 16, less for 32
// (measured over all z with 1 < rho < 3). The other factor of the speed may add to it.
constexpr double errorOfUnitKink = 0.05;
// A panel that ends beside a branch point at height y errs by at most 7 y^2 (measured, y > 1e-8),
// even if it is far longer: so close to the line, the speed is as good as a true corner.
constexpr double errorBesideCorner = 7;

/// The one that lessens errors by `ratio`, or a little more.
HWY_INLINE const Ellipse& ellipseFor(double ratio, Nodes nodes) {
    constexpr int bitsOfMantissa = 52, exponentOfOne = 1023;
    const auto exponent = static_cast<int>(std::bit_cast<std::uint64_t>(ratio) >> bitsOfMantissa);
    const auto bits = std::max(exponent - exponentOfOne, 0) + 1;
    const auto entry = nodes == Nodes::sixteen ? 2 * bits : bits;
    return ellipses[std::min(static_cast<std::size_t>(entry), ellipses.size() - 1)];
}

HWY_INLINE double lesser(double a, double b) {
    return a < b ? a : b;
}

struct Complex {
    double x, y;
};
HWY_INLINE Complex operator+(Complex a, Complex b) {
    return {a.x + b.x, a.y + b.y};
}
HWY_INLINE Complex operator*(double a, Complex b) {
    return {a * b.x, a * b.y};
}
HWY_INLINE Complex operator*(Complex a, Complex b) {
    return {a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x};
}
HWY_INLINE double norm(Complex a) {
    return a.x * a.x + a.y * a.y;
}
HWY_INLINE double aboutSize(Complex a) {
    return std::abs(a.x) + std::abs(a.y);
}
/// Without the library's care for errno.
HWY_INLINE double rootOf(double x) {
    const hn::CappedTag<double, 1> d;
    return hn::GetLane(hn::Sqrt(hn::Set(d, x)));
}

/// One of the two square roots, the other being opposite.
HWY_INLINE Complex anyRoot(Complex square) {
    const double size = rootOf(norm(square));
    const double more = rootOf(0.5 * (size + std::abs(square.x)));
    const double less = more > 0 ? 0.5 * square.y / more : 0;
    return square.x >= 0 ? Complex{more, less} : Complex{less, more};
}

/// Where a branch point lies: beside the line of parameters, and how far off it.
struct BranchPoint {
    double u = 0, height = 0;
    bool isNear = false; ///< others are not felt
    bool isCorner = false;

    /// x / y.
    HWY_INLINE BranchPoint(Complex x, Complex y) {
        constexpr double far = 100; // from there nothing is felt
        const double over = 1 / norm(y);
        const double real = over * (x.x * y.x + x.y * y.y);
        const double imaginary = std::abs(over * (x.y * y.x - x.x * y.y));
        isNear = std::abs(real) < far && imaginary < far; // not where y is zero
        u = isNear ? real : far;
        height = isNear ? imaginary : far;
    }

    /// The half width h of the panel whose ellipse passes through the point, from a place to which
    /// it lies `ahead`: (ahead - h)^2 / A^2 + height^2 / B^2 = h^2. Half a corner is no kink.
    HWY_INLINE double reach(double ahead, const Ellipse& ellipse) const {
        const double slope = ahead * ellipse.overA2;
        const double off = ahead * slope + height * height * ellipse.overB2;
        const double h = (rootOf(slope * slope + ellipse.rest * off) - slope) * ellipse.overRest;
        return isCorner ? 1 : h;
    }
};

/// The points off which the size of the complex parabola a + b u + c u^2 is smooth.
class BranchPoints {
  public:
    HWY_INLINE BranchPoints(Complex a, Complex b, Complex c, double tolerance)
        : BranchPoints(a, b, c, anyRoot(b * b + -4.0 * (a * c)), tolerance) {}

    /// Whether any panel of this half width is good.
    HWY_INLINE bool isGood(double half) const { return ratio_ * half * half <= 1; }
    /// Off which the points must lie where the half width is no more than this.
    HWY_INLINE const Ellipse& ellipse(double half, Nodes nodes) const {
        return ellipseFor(ratio_ * half * half, nodes);
    }

    /// The end of the longest good panel from `start`, at most `end`.
    HWY_INLINE double endOf(double start, double end, const Ellipse& ellipse) const {
        const double widest =
            lesser(one_.reach(one_.u - start, ellipse), other_.reach(other_.u - start, ellipse));
        const double last = lesser(start + 2 * widest, end);
        return one_.isCorner || other_.isCorner ? lesser(last, cornerAfter(start)) : last;
    }

    /// The start of the longest good panel to `end`, at least `start`.
    HWY_INLINE double startOf(double start, double end, const Ellipse& ellipse) const {
        const double widest =
            lesser(one_.reach(end - one_.u, ellipse), other_.reach(end - other_.u, ellipse));
        const double first = -lesser(2 * widest - end, -start);
        return one_.isCorner || other_.isCorner ? std::max(first, cornerBefore(end)) : first;
    }

  private:
    /// Of -b and the root of the discriminant, the sum that does not cancel.
    static HWY_INLINE Complex sumOf(Complex b, Complex root) {
        const double sign = std::copysign(0.5, b.x * root.x + b.y * root.y);
        return -0.5 * b + -sign * root;
    }

    HWY_INLINE BranchPoints(Complex a, Complex b, Complex c, Complex root, double tolerance)
        : one_(sumOf(b, root), c), other_(a, sumOf(b, root)) {
        // How fast the speed grows with the distance from a branch point, at most. The difference
        // of the points is root / c, their sum -b / c: known before the points are.
        const Complex overC = 1 / norm(c) * Complex{c.x, -c.y};
        const auto difference = root * overC;
        const double heights =
            std::max(std::abs(difference.y), std::abs(b.x * overC.y + b.y * overC.x));
        const double strength = one_.isNear && other_.isNear
                                    ? aboutSize(c) * (std::abs(difference.x) + heights)
                                    : aboutSize(root);
        ratio_ = errorOfUnitKink / tolerance * strength;
        const double flat = 0.5 * tolerance;
        one_.isCorner = errorBesideCorner * strength * one_.height * one_.height <= flat;
        other_.isCorner = errorBesideCorner * strength * other_.height * other_.height <= flat;
    }

    double cornerAfter(double start) const {
        double corner = 1;
        for (const auto* point : {&one_, &other_}) {
            corner = point->isCorner && point->u > start ? std::min(corner, point->u) : corner;
        }
        return corner;
    }

    double cornerBefore(double end) const {
        double corner = 0;
        for (const auto* point : {&one_, &other_}) {
            corner = point->isCorner && point->u < end ? std::max(corner, point->u) : corner;
        }
        return corner;
    }

    BranchPoint one_, other_;
    double ratio_ = 0; // error of a kink of unit width, in tolerances
};

void cut(const Parabola& velocity, double tolerance, Nodes nodes, Panels& panels) {
    const auto& [a, b, c, dimension] = velocity;
    const BranchPoints points({a[0], a[1]}, {b[0], b[1]}, {c[0], c[1]}, tolerance);
    std::array<double, Panels::most / 2> back; // joints from the end
    std::size_t front = 0, behind = 0;
    double start = 0, end = 1;
    // From both ends at once: for either way, each panel waits for the one before.
    panels.joints[0] = start;
    while (behind + 1 < back.size() && !points.isGood(0.5 * (end - start))) {
        const auto& ellipse = points.ellipse(0.5 * (end - start), nodes);
        const double next = points.endOf(start, end, ellipse);
        const double last = points.startOf(start, end, ellipse);
        if (!(start < next && last < end)) {
            break;
        }
        if (next >= last) { // Also where one panel would do: to guess which costs more than it.
            panels.joints[++front] = 0.5 * (next + last);
            break;
        }
        panels.joints[++front] = start = next;
        back[behind++] = end = last;
    }
    std::reverse_copy(back.begin(), back.begin() + behind, &panels.joints[front + 1]);
    panels.count = front + behind + 1;
    panels.joints[panels.count] = 1;
}

} // namespace
} // namespace splineloft::lanes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace splineloft::lanes {

HWY_EXPORT(cut);

void cutIntoPanels(const Parabola& velocity, double tolerance, Nodes nodes, Panels& panels) {
    HWY_DYNAMIC_DISPATCH(cut)(velocity, tolerance, nodes, panels);
}

} // namespace splineloft::lanes
#endif
