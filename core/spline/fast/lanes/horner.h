// Polynomials made ready for Horner's scheme, in which one multiplication and one addition a degree
// give the value.
//
// Up to degree 5 they are in power form about u = 0. From random Bézier points of size 1 its
// coefficients can grow to 3^degree together and cancel again, which costs as many roundings.
// Above, we keep the Bernstein form (Volk and Schumaker 1990): with r = u / (1 - u) the value is
// (1 - u)^n times a polynomial in r whose coefficients are binomial(n, k) b_k. Nothing cancels that
// does not cancel in the Bernstein form itself. To keep r below 1 the half beyond u = 1/2 is seen
// from the other end: a second set of coefficients, in reverse.
//
// In single precision the power form is one about u = 1/2, where little cancels: it loses about as
// much as rounding the points does.
#pragma once

#include <cstddef>
#include <vector>

namespace splineloft::lanes {

/// Degrees up to this have a power form; its loss of 3^5 roundings at worst is 3e-14.
inline constexpr int mostPowerDegree = 5;
/// Degrees up to this have a scaled form: 2^400 times the points, and 2^-400, stay finite.
inline constexpr int mostScaledDegree = 400;

/// Whether a polynomial of this degree is kept in scaled Bernstein form, in two sets.
inline constexpr bool isScaled(int degree) {
    return degree > mostPowerDegree;
}

/// Numbers that the coefficients of one polynomial take: one set of degree + 1, or two.
inline constexpr std::size_t coefficientCount(int degree) {
    return static_cast<std::size_t>(degree + 1) * (isScaled(degree) ? 2 : 1);
}

/// Turns Bernstein coefficients into those of Horner's scheme.
class CoefficientMaker {
  public:
    explicit CoefficientMaker(int degree);

    int degree() const { return degree_; }
    /// Reads the (degree + 1) x width numbers of a piece, Bézier point after Bézier point. Writes
    /// `coefficientCount(degree)` rows of width numbers: constants first, then what belongs to x,
    /// and so on.
    void make(const double* bezier, std::size_t width, double* coefficients) const;
    /// The same about u = 1/2, rounded once, for degrees that have a power form; and one row more:
    /// the first Bézier point, which is not exact about u = 1/2.
    void makeCentred(const double* bezier, std::size_t width, float* coefficients) const;

  private:
    int degree_;
    std::vector<double> binomials_;
};

/// Consecutive samples that are evaluated with the same set of coefficients.
template <class Lane> struct Run {
    std::size_t set = 0;     ///< 1: seen from the end
    std::size_t first = 0;   ///< sample
    std::size_t count = 0;   ///< of samples
    std::vector<Lane> x;     ///< u, its ratio, or u - 1/2; padded by `runPadding` finite numbers
    std::vector<Lane> scale; ///< factor of the value; empty in power form
};

/// Lanes may read so far beyond a run (64 bytes hold sixteen floats).
inline constexpr std::size_t runPadding = 64;

/// The samples u = k / perPiece, 0 <= k < perPiece, for polynomials of this degree.
std::vector<Run<double>> runsOf(int degree, std::size_t perPiece);

/// The same samples for coefficients about u = 1/2.
Run<float> centredRun(std::size_t perPiece);

} // namespace splineloft::lanes
