// Least squares for one or two unknown factors: with what parameters a family would draw what is
// seen. The rows come from the curve itself, so they fit exactly or not at all.
#pragma once

#include "core/spline/point.h"

#include <cmath>
#include <optional>
#include <vector>

namespace splineloft::conversion {

/// The equation x first + y second = right, one for each coordinate.
struct Row {
    Point first, second, right;
};

/// The factors of a row.
struct Factors {
    double x = 0, y = 0;
};

// Two columns closer to parallel than this (sine squared) do not tell their factors apart.
inline constexpr double leastIndependence = 1e-16;

/// The x that best makes x first = right; nothing where all `first` vanish.
inline std::optional<double> fitOne(const std::vector<Row>& rows, double tolerance) {
    double x = 0;
    for (int refinement = 0; refinement < 2; ++refinement) {
        double square = 0, product = 0;
        for (const auto& row : rows) {
            square += dot(row.first, row.first);
            product += dot(row.first, row.right - x * row.first);
        }
        if (!(square > tolerance * tolerance)) {
            return std::nullopt;
        }
        x += product / square;
    }
    return x;
}

/// The x and y that best make x first + y second = right; nothing where the rows do not tell them
/// apart. The second round fits what rounding left of the first.
inline std::optional<Factors> fitTwo(const std::vector<Row>& rows) {
    Factors factors;
    for (int refinement = 0; refinement < 2; ++refinement) {
        double aa = 0, ab = 0, bb = 0, ar = 0, br = 0;
        for (const auto& row : rows) {
            const Point rest = row.right - factors.x * row.first - factors.y * row.second;
            aa += dot(row.first, row.first);
            ab += dot(row.first, row.second);
            bb += dot(row.second, row.second);
            ar += dot(row.first, rest);
            br += dot(row.second, rest);
        }
        const double determinant = aa * bb - ab * ab;
        if (!(determinant > leastIndependence * aa * bb)) {
            return std::nullopt;
        }
        factors.x += (bb * ar - ab * br) / determinant;
        factors.y += (aa * br - ab * ar) / determinant;
    }
    return factors;
}

} // namespace splineloft::conversion
