// Polynomials in Bernstein form on [0, 1], given by their coefficients: degree + 1 of them. What is
// asked of a curve (where is it level, nearest, crossed, bent the other way) is a zero of one.
// (Farin and Farouki 2012 survey the form and its arithmetic.)
#pragma once

#include <span>
#include <vector>

namespace splineloft {

/// The coefficients of a polynomial.
using Bernstein = std::vector<double>;

/// The product, of the sum of the degrees. Never larger than the largest coefficients' product.
Bernstein product(std::span<const double> a, std::span<const double> b);

/// The sum a + factor * b of two polynomials of the same degree.
Bernstein sum(std::span<const double> a, std::span<const double> b, double factor = 1);

/// The derivative, of one degree less; of a constant, zero.
Bernstein derivative(std::span<const double> a);

/// The same polynomial as one of `degree`, which is not below its own.
Bernstein elevated(std::span<const double> a, int degree);

/// The value at u, by de Casteljau's ladder.
double valueAt(std::span<const double> a, double u);

} // namespace splineloft
