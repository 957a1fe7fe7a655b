#include "tests/bench/reference.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace splineloft::bench {

std::vector<double> Dice::between(std::size_t count, double low, double high) {
    std::vector<double> values(count);
    for (auto& value : values) {
        value = between(low, high);
    }
    return values;
}

Taylor catmullRom(const double* p, std::size_t stride, long double u) {
    const long double a = p[0], b = p[stride], c = p[2 * stride], d = p[3 * stride];
    const auto linear = (c - a) / 2;
    const auto quadratic = (2 * a - 5 * b + 4 * c - d) / 2;
    const auto cubic = (3 * b - a - 3 * c + d) / 2;
    return {.value = b + u * (linear + u * (quadratic + u * cubic)),
            .first = linear + u * (2 * quadratic + u * 3 * cubic),
            .second = 2 * quadratic + u * 6 * cubic};
}

Taylor bezier(const double* p, std::size_t stride, int degree, long double u) {
    std::vector<long double> rungs;
    for (int i = 0; i <= degree; ++i) {
        rungs.push_back(p[static_cast<std::size_t>(i) * stride]);
    }
    Taylor result;
    for (auto left = rungs.size(); left > 1; --left) {
        if (left == 3) {
            result.second = degree * (degree - 1) * (rungs[0] - 2 * rungs[1] + rungs[2]);
        }
        if (left == 2) {
            result.first = degree * (rungs[1] - rungs[0]);
        }
        for (std::size_t i = 0; i + 1 < left; ++i) {
            rungs[i] = (1 - u) * rungs[i] + u * rungs[i + 1];
        }
    }
    result.value = rungs[0];
    return result;
}

long double deBoor(const double* points, std::size_t stride, std::span<const double> knots,
                   int degree, std::size_t piece, long double t) {
    const auto d = static_cast<std::size_t>(degree);
    std::vector<long double> rungs;
    for (std::size_t i = 0; i <= d; ++i) {
        rungs.push_back(points[(piece + i) * stride]);
    }
    for (std::size_t level = 1; level <= d; ++level) {
        for (std::size_t i = 0; i + level <= d; ++i) {
            const long double a = knots[piece + i + level];
            const long double b = knots[piece + i + d + 1];
            const auto part = (t - a) / (b - a);
            rungs[i] = (1 - part) * rungs[i] + part * rungs[i + 1];
        }
    }
    return rungs[0];
}

namespace {

constexpr int gaussPoints = 16;
/// Below this part of the whole, halves and whole are said to agree.
constexpr long double agreement = 1e-17L;
/// At a cusp halving would never end; what is left after so many is below rounding.
constexpr int mostHalvings = 60;

struct GaussRule {
    std::array<long double, gaussPoints> place, weight; // on [-1, 1]
};

/// Zeros of the Legendre polynomial by Newton's method, and the weights that belong to them.
GaussRule makeGaussRule() {
    GaussRule rule{};
    for (std::size_t i = 0; i < gaussPoints; ++i) {
        long double x = std::cos(std::numbers::pi_v<long double> *
                                 (static_cast<long double>(i) + 0.75L) / (gaussPoints + 0.5L));
        long double slope = 1;
        for (int step = 0; step < 100; ++step) {
            long double previous = 1, value = x;
            for (int n = 2; n <= gaussPoints; ++n) {
                const auto next = ((2 * n - 1) * x * value - (n - 1) * previous) / n;
                previous = value;
                value = next;
            }
            slope = gaussPoints * (x * value - previous) / (x * x - 1);
            x -= value / slope;
        }
        rule.place[i] = x;
        rule.weight[i] = 2 / ((1 - x * x) * slope * slope);
    }
    return rule;
}

/// The speed of a plane cubic, as the hodograph's power coefficients.
struct Speed {
    std::array<std::array<long double, 3>, 2> hodograph{};

    explicit Speed(const double* p) {
        for (std::size_t c = 0; c < 2; ++c) {
            const long double a = p[c], b = p[2 + c], d = p[4 + c], e = p[6 + c];
            hodograph[c] = {3 * (b - a), 6 * (a - 2 * b + d), 3 * (e - 3 * d + 3 * b - a)};
        }
    }
    long double operator()(long double u) const {
        const auto& [x, y] = hodograph;
        return std::hypot(x[0] + u * (x[1] + u * x[2]), y[0] + u * (y[1] + u * y[2]));
    }
};

long double panel(const Speed& speed, long double start, long double end) {
    static const auto rule = makeGaussRule();
    const auto middle = (start + end) / 2;
    const auto half = (end - start) / 2;
    long double sum = 0;
    for (std::size_t i = 0; i < gaussPoints; ++i) {
        sum += rule.weight[i] * speed(middle + half * rule.place[i]);
    }
    return half * sum;
}

long double refined(const Speed& speed, long double start, long double end, long double whole,
                    long double tolerance, int halvings) {
    const auto middle = (start + end) / 2;
    const auto left = panel(speed, start, middle);
    const auto right = panel(speed, middle, end);
    if (halvings == 0 || std::abs(left + right - whole) <= tolerance) {
        return left + right;
    }
    return refined(speed, start, middle, left, tolerance, halvings - 1) +
           refined(speed, middle, end, right, tolerance, halvings - 1);
}

} // namespace

long double cubicLength(const double* bezier, long double end) {
    const Speed speed(bezier);
    const auto whole = panel(speed, 0, end);
    return refined(speed, 0, end, whole, agreement * whole, mostHalvings);
}

NaturalReference::NaturalReference(std::span<const double> x, std::span<const double> y)
    : x_(x), y_(y), second_(x.size(), 0) {
    // Rows h[i-1] M[i-1] + 2 (h[i-1] + h[i]) M[i] + h[i] M[i+1] = 6 (slope[i] - slope[i-1]),
    // eliminated downwards and solved upwards.
    const auto h = [x](std::size_t i) { return static_cast<long double>(x[i + 1]) - x[i]; };
    const auto slope = [y, h](std::size_t i) {
        return (static_cast<long double>(y[i + 1]) - y[i]) / h(i);
    };
    std::vector<long double> over(x.size(), 0);
    for (std::size_t i = 1; i + 1 < x.size(); ++i) {
        const auto pivot = 2 * (h(i - 1) + h(i)) - h(i - 1) * over[i - 1];
        over[i] = h(i) / pivot;
        second_[i] = (6 * (slope(i) - slope(i - 1)) - h(i - 1) * second_[i - 1]) / pivot;
    }
    for (auto i = x.size() - 2; i > 0; --i) {
        second_[i] -= over[i] * second_[i + 1];
    }
}

long double NaturalReference::at(double x) const {
    const auto above = std::upper_bound(x_.begin() + 1, x_.end() - 1, x);
    const auto i = static_cast<std::size_t>(above - x_.begin()) - 1;
    const auto h = static_cast<long double>(x_[i + 1]) - x_[i];
    const auto a = (static_cast<long double>(x_[i + 1]) - x) / h;
    const auto b = (static_cast<long double>(x) - x_[i]) / h;
    return a * y_[i] + b * y_[i + 1] +
           ((a * a * a - a) * second_[i] + (b * b * b - b) * second_[i + 1]) * h * h / 6;
}

long double NaturalReference::slopeAtStart() const {
    const auto h = static_cast<long double>(x_[1]) - x_[0];
    return (static_cast<long double>(y_[1]) - y_[0]) / h - h / 6 * second_[1];
}

long double NaturalReference::slopeAtEnd() const {
    const auto last = x_.size() - 1;
    const auto h = static_cast<long double>(x_[last]) - x_[last - 1];
    return (static_cast<long double>(y_[last]) - y_[last - 1]) / h + h / 6 * second_[last - 1];
}

std::vector<double> bezierOfCatmullRom(std::span<const double> points, int dimension) {
    const auto d = static_cast<std::size_t>(dimension);
    std::vector<double> bezier;
    for (std::size_t i = 0; i + 3 * d < points.size(); i += d) {
        const auto p = points.subspan(i, 4 * d);
        for (std::size_t k = 0; k < 4; ++k) {
            for (std::size_t c = 0; c < d; ++c) {
                const double inner = k == 1 ? (p[2 * d + c] - p[c]) / 6
                                            : (k == 2 ? -(p[3 * d + c] - p[d + c]) / 6 : 0);
                bezier.push_back(p[(k < 2 ? d : 2 * d) + c] + inner);
            }
        }
    }
    return bezier;
}

std::vector<double> bezierOfCubicBSpline(std::span<const double> points,
                                         std::span<const double> knots) {
    // The blossom with `ends` arguments at the end of the piece, the others at its start.
    const auto blossom = [&](std::size_t piece, std::size_t ends, std::size_t coordinate) {
        std::array<long double, 4> rungs{};
        for (std::size_t i = 0; i < 4; ++i) {
            rungs[i] = points[2 * (piece + i) + coordinate];
        }
        for (std::size_t level = 1; level <= 3; ++level) {
            const long double argument = knots[level <= ends ? piece + 4 : piece + 3];
            for (std::size_t i = 0; i + level <= 3; ++i) {
                const long double a = knots[piece + i + level];
                const long double b = knots[piece + i + 4];
                const auto part = (argument - a) / (b - a);
                rungs[i] = (1 - part) * rungs[i] + part * rungs[i + 1];
            }
        }
        return static_cast<double>(rungs[0]);
    };
    std::vector<double> bezier;
    for (std::size_t piece = 0; piece + 3 < points.size() / 2; ++piece) {
        for (std::size_t k = 0; k < 4; ++k) {
            bezier.push_back(blossom(piece, k, 0));
            bezier.push_back(blossom(piece, k, 1));
        }
    }
    return bezier;
}

std::vector<double> clampedKnots(std::size_t pieces, int degree) {
    const auto d = static_cast<std::size_t>(degree);
    std::vector<double> knots(d, 0);
    for (std::size_t i = 0; i <= pieces; ++i) {
        knots.push_back(static_cast<double>(i));
    }
    knots.insert(knots.end(), d, static_cast<double>(pieces));
    return knots;
}

} // namespace splineloft::bench
