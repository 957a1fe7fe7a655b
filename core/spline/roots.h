// Zeros of polynomials in Bernstein form: what extrema, inflections and crossings come down to.
#pragma once

#include <span>
#include <vector>

namespace splineloft {

/// The zeros in [0, 1] of the polynomial with these Bernstein coefficients, in order. Where it
/// vanishes together with its derivative a zero may be found twice or, within rounding, not at all;
/// the zero polynomial has none. Bounded work for any input. (Descartes' rule in Bernstein form:
/// the zeros are never more than the changes of sign; Lane and Riesenfeld 1981.)
std::vector<double> rootsOf(std::span<const double> coefficients);

} // namespace splineloft
