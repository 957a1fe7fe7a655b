// Whole numbers over whole numbers, exactly.
#pragma once

#include <cstdint>
#include <string>

namespace splineloft {

/// A fraction in lowest terms, its denominator above zero. Arithmetic is exact; where a result does
/// not fit in 64 bits it throws std::overflow_error, and dividing by zero std::domain_error.
class Rational {
  public:
    Rational() = default;
    /// NOLINTNEXTLINE(google-explicit-constructor): a whole number is a fraction.
    Rational(std::int64_t whole) : numerator_(whole) {}
    Rational(std::int64_t numerator, std::int64_t denominator);

    std::int64_t numerator() const { return numerator_; }
    std::int64_t denominator() const { return denominator_; }
    /// The double next to it, but for the rounding of numerator and denominator above 2^53.
    double value() const {
        return static_cast<double>(numerator_) / static_cast<double>(denominator_);
    }
    bool operator==(const Rational&) const = default;

    friend Rational operator+(Rational a, Rational b);
    friend Rational operator-(Rational a, Rational b);
    friend Rational operator*(Rational a, Rational b);
    friend Rational operator/(Rational a, Rational b);

  private:
    std::int64_t numerator_ = 0, denominator_ = 1;
};

/// "-3/4", or "2" where it is whole.
std::string textOf(Rational number);

} // namespace splineloft
