#include "core/spline/algebra/rounded.h"

#include "core/spline/algebra/roots.h"
#include "core/spline/algebra/scale.h"

#include <algorithm>
#include <cmath>

namespace splineloft {
namespace {

// The relative rounding that Bézier points come with: families round a few times.
constexpr double roundingOfPoints = 4 * epsilon;

/// The e for which `value` is m * 2^e with 1/2 <= m < 1; 0 for zero and for what is not finite.
int exponentOf(double value) {
    int exponent = 0;
    if (std::isfinite(value)) {
        std::frexp(value, &exponent);
    }
    return exponent;
}

void scaleBy(Bernstein& coefficients, int exponent) {
    for (double& c : coefficients) {
        c = std::ldexp(c, exponent);
    }
}

double degreeOf(const Rounded& a) {
    return static_cast<double>(a.coefficients.size() - 1);
}

} // namespace

int Rounded::signAt(double u) const {
    const double value = valueAt(coefficients, u);
    return value > rounding ? 1 : value < -rounding ? -1 : 0;
}

bool Rounded::isZero() const {
    return !(largestOf(coefficients) > rounding);
}

std::vector<double> Rounded::roots() const {
    return rootsOf(coefficients, rounding);
}

Rounded product(const Rounded& a, const Rounded& b) {
    const double largestA = largestOf(a.coefficients);
    const double largestB = largestOf(b.coefficients);
    const double steps = degreeOf(a) + degreeOf(b) + 2;
    return {product(a.coefficients, b.coefficients), largestA * b.rounding + largestB * a.rounding +
                                                         a.rounding * b.rounding +
                                                         steps * epsilon * largestA * largestB};
}

Rounded sum(const Rounded& a, const Rounded& b, double factor) {
    const auto degree = static_cast<int>(std::max(degreeOf(a), degreeOf(b)));
    Rounded result{sum(elevated(a.coefficients, degree), elevated(b.coefficients, degree), factor),
                   a.rounding + std::abs(factor) * b.rounding};
    result.rounding += epsilon * largestOf(result.coefficients);
    return result;
}

Rounded derivative(const Rounded& a) {
    return {derivative(a.coefficients), 2 * degreeOf(a) * a.rounding};
}

Rounded scaled(Rounded a) {
    const int exponent = exponentOf(largestOf(a.coefficients));
    scaleBy(a.coefficients, -exponent);
    a.rounding = std::ldexp(a.rounding, -exponent);
    return a;
}

Rounded LocalPiece::velocity(int coordinate) const {
    const Rounded& own = coordinates[static_cast<std::size_t>(coordinate)];
    if (form == Form::polynomial) {
        return derivative(own);
    }
    return sum(product(derivative(own), weight), product(own, derivative(weight)), -1);
}

LocalPiece localPiece(const Piece& piece, const Point& place) {
    LocalPiece local;
    local.form = piece.form;
    Bernstein weight = {1};
    int weightExponent = 0;
    if (piece.form == Form::rational) {
        weight = piece.column(piece.dimension);
        weightExponent = exponentOf(largestOf(weight));
        scaleBy(weight, -weightExponent);
    }
    local.weight = {weight, piece.form == Form::rational ? roundingOfPoints : 0};
    // Everything is made smaller than 1/2 before it is subtracted, for differences can overflow.
    double farthest = 0;
    std::vector<Bernstein> columns;
    for (int c = 0; c < piece.dimension; ++c) {
        columns.push_back(piece.column(c));
        scaleBy(columns.back(), -weightExponent);
        farthest = std::max({farthest, largestOf(columns.back()), std::abs(place[c])});
    }
    const int exponent = exponentOf(farthest) + 1;
    double largest = 0;
    for (int c = 0; c < piece.dimension; ++c) {
        Bernstein& column = columns[static_cast<std::size_t>(c)];
        scaleBy(column, -exponent);
        const double from = std::ldexp(place[c], -exponent);
        for (std::size_t i = 0; i < column.size(); ++i) {
            column[i] -= from * (weight.size() > 1 ? weight[i] : 1);
        }
        largest = std::max(largest, largestOf(column));
    }
    const int again = exponentOf(largest);
    const double rounding = std::ldexp(roundingOfPoints * std::ldexp(farthest, -exponent), -again);
    for (auto& column : columns) {
        scaleBy(column, -again);
        local.coordinates.push_back({std::move(column), rounding});
    }
    return local;
}

} // namespace splineloft
