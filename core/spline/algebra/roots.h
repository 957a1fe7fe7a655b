// Zeros of polynomials in Bernstein form: what extrema, inflections and crossings come down to.
#pragma once

#include <span>
#include <vector>

namespace splineloft {

/// The zeros in [0, 1] of the polynomial with these Bernstein coefficients, in order, each once. A
/// zero without a change of sign (the polynomial touches zero and turns back) is found as well, as
/// long as it reaches zero within rounding; zeros so close together that rounding does not part
/// them are one. The zero polynomial has none. Bounded work for any input. (Descartes' rule in
/// Bernstein form: the zeros are never more than the changes of sign; Lane and Riesenfeld 1981.)
std::vector<double> rootsOf(std::span<const double> coefficients);

/// The same where the coefficients are known to `rounding` only: what is not larger counts as zero.
std::vector<double> rootsOf(std::span<const double> coefficients, double rounding);

} // namespace splineloft
