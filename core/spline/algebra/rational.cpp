#include "core/spline/algebra/rational.h"

#include <limits>
#include <stdexcept>

namespace splineloft {
namespace {

// Products of two 64-bit numbers, and sums of two such, fit.
__extension__ using Wide = __int128;

Wide magnitude(Wide a) {
    return a < 0 ? -a : a;
}

Wide commonDivisor(Wide a, Wide b) {
    while (b != 0) {
        const Wide rest = a % b;
        a = b;
        b = rest;
    }
    return magnitude(a);
}

std::int64_t narrowed(Wide a) {
    if (a > std::numeric_limits<std::int64_t>::max() ||
        a < -std::numeric_limits<std::int64_t>::max()) {
        throw std::overflow_error("a fraction needs more than 64 bits");
    }
    return static_cast<std::int64_t>(a);
}

Rational fraction(Wide numerator, Wide denominator) {
    if (denominator == 0) {
        throw std::domain_error("a fraction's denominator is 0");
    }
    const Wide divisor = commonDivisor(numerator, denominator) * (denominator < 0 ? -1 : 1);
    Rational result(narrowed(numerator / divisor));
    if (denominator != divisor) {
        result = Rational(result.numerator(), narrowed(denominator / divisor));
    }
    return result;
}

} // namespace

Rational::Rational(std::int64_t numerator, std::int64_t denominator) {
    if (denominator == 0) {
        throw std::domain_error("a fraction's denominator is 0");
    }
    const Wide divisor = commonDivisor(numerator, denominator) * (denominator < 0 ? -1 : 1);
    numerator_ = narrowed(numerator / divisor);
    denominator_ = narrowed(denominator / divisor);
}

Rational operator+(Rational a, Rational b) {
    // Two products of 63 bits each: their sum has 127 at most.
    return fraction(static_cast<Wide>(a.numerator_) * b.denominator_ +
                        static_cast<Wide>(b.numerator_) * a.denominator_,
                    static_cast<Wide>(a.denominator_) * b.denominator_);
}

Rational operator-(Rational a, Rational b) {
    return a + Rational(-1) * b;
}

Rational operator*(Rational a, Rational b) {
    return fraction(static_cast<Wide>(a.numerator_) * b.numerator_,
                    static_cast<Wide>(a.denominator_) * b.denominator_);
}

Rational operator/(Rational a, Rational b) {
    return fraction(static_cast<Wide>(a.numerator_) * b.denominator_,
                    static_cast<Wide>(a.denominator_) * b.numerator_);
}

std::string textOf(Rational number) {
    const std::string whole = std::to_string(number.numerator());
    return number.denominator() == 1 ? whole : whole + "/" + std::to_string(number.denominator());
}

} // namespace splineloft
