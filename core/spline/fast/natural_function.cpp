#include "core/spline/fast/natural_function.h"

#include "core/spline/fast/lanes/natural_lanes.h"
#include "core/spline/fast/natural_slopes.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace splineloft {
namespace {

// Sizes between these need no care: products and quotients of a few do not overflow.
constexpr double tiny = 0x1p-250;
constexpr double narrow = 0x1p-150;
constexpr double huge = 0x1p250;

// So many places are worked out side by side: their waits for memory and division overlap.
constexpr std::size_t batch = 32;

std::string named(char name, std::size_t index, double value) {
    std::array<char, 32> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
    return std::string{name} + "[" + std::to_string(index) + "] = " + std::string(text.data(), end);
}

void requireSizes(std::size_t x, std::size_t y) {
    if (x != y) {
        throw std::invalid_argument("there are " + std::to_string(x) + " values of x and " +
                                    std::to_string(y) + " of y; right would be as many of both");
    }
    if (x < 2 || x > std::numeric_limits<std::uint32_t>::max()) {
        throw std::invalid_argument("there are " + std::to_string(x) +
                                    " points; right would be 2 to 4294967295");
    }
}

void requireFinite(char name, std::span<const double> values) {
    const auto bad = std::ranges::find_if(values, [](double v) { return !std::isfinite(v); });
    if (bad != values.end()) {
        throw std::invalid_argument(
            named(name, static_cast<std::size_t>(bad - values.begin()), *bad) +
            " is not a finite number; right would be a finite one");
    }
}

/// Slopes on intervals beyond this ratio could not be told apart, or overflow.
constexpr double mostUneven = 1e100;

void requireComparable(std::span<const double> x, double leastInterval) {
    const double whole = x.back() / 2 - x.front() / 2;
    if (leastInterval < whole / mostUneven) {
        throw std::invalid_argument("two x are 10^100 times closer than the first and the "
                                    "last; right would be values not so far apart");
    }
}

void requireRising(std::span<const double> x, const lanes::Survey& survey) {
    if (survey.rises && std::isfinite(x.front()) && std::isfinite(x.back())) {
        requireComparable(x, survey.leastInterval);
        return;
    }
    requireFinite('x', x);
    for (std::size_t i = 1; i < x.size(); ++i) {
        if (x[i - 1] >= x[i]) {
            throw std::invalid_argument(named('x', i, x[i]) + " is not above " +
                                        named('x', i - 1, x[i - 1]) +
                                        "; right would be rising values");
        }
    }
}

bool allTiny(std::span<const double> values) {
    return std::ranges::all_of(values, [](double v) { return std::abs(v) < tiny; });
}

/// The exponent that brings `size` near 1, as far as factors of that size can be written.
int exponentFor(double size) {
    return size > 0 ? std::clamp(std::ilogb(size), -1000, 1023) : 0;
}

} // namespace

NaturalFunction::NaturalFunction(std::span<const double> x, std::span<const double> y) {
    refit(x, y);
}

void NaturalFunction::refit(std::span<const double> x, std::span<const double> y) {
    requireSizes(x.size(), y.size());
    const auto survey = lanes::surveyOf(x.data(), y.data(), x.size(), huge);
    requireRising(x, survey);
    if (!survey.isModest) {
        requireFinite('y', y);
    }
    size_ = x.size();
    values_.resize(3 * size_);
    normalize(x, y, survey.isModest);
    table_.begin(size_ - 1, x.front() * xFactor_, x.back() * xFactor_);
    NaturalSlopes solver(xs(), ys(), std::span(values_).last(size_));
    std::size_t brought = 0;
    for (std::size_t block = 0; block < solver.blocks(); ++block) {
        const std::size_t end = solver.pointsFor(block);
        bring(x.first(end), y.first(end), brought);
        table_.enter(values_.data(), brought, end);
        const bool isLast = end == size_;
        solver.solve(block, isLast ? lanes::Upcoming{} : lanes::Upcoming{&x[end], &y[end]});
        brought = end;
    }
}

/// Chooses our units.
void NaturalFunction::normalize(std::span<const double> x, std::span<const double> y,
                                bool isModest) {
    xExponent_ = yExponent_ = 0;
    const double whole = x.back() / 2 - x.front() / 2;
    if (!(whole >= narrow && whole <= huge)) {
        xExponent_ = exponentFor(std::max(whole, std::numeric_limits<double>::min()));
    }
    if (!isModest || allTiny(y)) {
        const auto bySize = [](double a, double b) { return std::abs(a) < std::abs(b); };
        yExponent_ = exponentFor(std::abs(*std::ranges::max_element(y, bySize)));
    }
    xFactor_ = std::ldexp(1, -xExponent_);
    yFactor_ = std::ldexp(1, yExponent_);
}

/// Takes over the points from `first` on.
void NaturalFunction::bring(std::span<const double> x, std::span<const double> y,
                            std::size_t first) {
    const auto take = [first](std::span<const double> from, double* to, int exponent) {
        std::copy(from.data() + first, from.data() + from.size(), to + first);
        for (auto& value :
             std::span(to, from.size()).subspan(exponent == 0 ? from.size() : first)) {
            value = std::ldexp(value, -exponent);
        }
    };
    take(x, values_.data(), xExponent_);
    take(y, values_.data() + size_, yExponent_);
}

/// The piece `step` pieces on, if it begins at or before x, else `piece`. Without a branch, as half
/// of all guesses would be wrong.
inline std::size_t NaturalFunction::towards(double x, std::size_t piece, std::size_t step) const {
    const std::size_t next = std::min(piece + step, size() - 2);
    return piece + ((next - piece) & (std::size_t{0} - std::size_t{xs()[next] <= x}));
}

inline NaturalFunction::Place NaturalFunction::clamp(double x) const {
    const double within = std::min(std::max(xs().front(), x * xFactor_), xs().back());
    return {table_.pieceBefore(within), within, x * xFactor_ - within};
}

inline NaturalFunction::Place NaturalFunction::locate(double x) const {
    Place place = clamp(x);
    for (std::size_t step = table_.firstStep(); step > 0; step /= 2) {
        place.piece = towards(place.x, place.piece, step);
    }
    return place;
}

inline double NaturalFunction::chordSlope(std::size_t piece) const {
    return (ys()[piece + 1] - ys()[piece]) / interval(piece);
}

/// The chord, and a cubic that vanishes at both points: no rounding there, however it overshoots.
inline double NaturalFunction::valueAt(const Place& place) const {
    const std::size_t i = place.piece;
    const double h = interval(i);
    const double u = (place.x - xs()[i]) / h;
    const double rise = ys()[i + 1] - ys()[i];
    const double leaving = h * slopes()[i] - rise;
    const double arriving = rise - h * slopes()[i + 1];
    const double within = ys()[i] + u * (rise + (1 - u) * (leaving + u * (arriving - leaving)));
    const double outside = (place.beyond < 0 ? slopes().front() : slopes().back()) * place.beyond;
    return yFactor_ * (within + outside);
}

double NaturalFunction::operator()(double x) const {
    return valueAt(locate(x));
}

void NaturalFunction::evaluate(std::span<const double> x, std::span<double> out) const {
    if (x.size() != out.size()) {
        throw std::invalid_argument("there is room for " + std::to_string(out.size()) +
                                    " values at " + std::to_string(x.size()) +
                                    " places; right would be as many of both");
    }
    std::array<double, batch> within;
    std::array<std::size_t, batch> pieces;
    for (std::size_t first = 0; first < x.size(); first += batch) {
        const std::size_t count = std::min(batch, x.size() - first);
        for (std::size_t k = 0; k < count; ++k) {
            const Place place = clamp(x[first + k]);
            within[k] = place.x;
            pieces[k] = place.piece;
        }
        for (std::size_t step = table_.firstStep(); step > 0; step /= 2) {
            for (std::size_t k = 0; k < count; ++k) {
                pieces[k] = towards(within[k], pieces[k], step);
            }
        }
        for (std::size_t k = 0; k < count; ++k) {
            out[first + k] = valueAt({pieces[k], within[k], x[first + k] * xFactor_ - within[k]});
        }
    }
}

double NaturalFunction::derivative(double x) const {
    const Place place = locate(x);
    const std::size_t i = place.piece;
    const double u = (place.x - xs()[i]) / interval(i);
    const double chord = chordSlope(i);
    const double square = 3 * chord - 2 * slopes()[i] - slopes()[i + 1];
    const double cube = slopes()[i] + slopes()[i + 1] - 2 * chord;
    return std::ldexp(slopes()[i] + u * (2 * square + u * (3 * cube)), yExponent_ - xExponent_);
}

/// From the longer of the two pieces, as rounding errors are divided by its length.
double NaturalFunction::scaledSecondAt(std::size_t i) const {
    if (i == 0 || i + 1 >= size()) {
        return 0;
    }
    if (interval(i - 1) > interval(i)) {
        return 2 * (slopes()[i - 1] + 2 * slopes()[i] - 3 * chordSlope(i - 1)) / interval(i - 1);
    }
    return 2 * (3 * chordSlope(i) - 2 * slopes()[i] - slopes()[i + 1]) / interval(i);
}

double NaturalFunction::secondAt(std::size_t i) const {
    return std::ldexp(scaledSecondAt(i), yExponent_ - 2 * xExponent_);
}

double NaturalFunction::second(double x) const {
    const Place place = locate(x);
    if (place.beyond != 0) {
        return 0 * place.beyond; // keeps what is not a number
    }
    const double u = (place.x - xs()[place.piece]) / interval(place.piece);
    const double value =
        (1 - u) * scaledSecondAt(place.piece) + u * scaledSecondAt(place.piece + 1);
    return std::ldexp(value, yExponent_ - 2 * xExponent_);
}

/// From the beginning of a piece to x.
double NaturalFunction::integralWithin(std::size_t piece, double x) const {
    const double h = interval(piece);
    const double u = (x - xs()[piece]) / h;
    const double rise = ys()[piece + 1] - ys()[piece];
    const double leaving = h * slopes()[piece];
    const double arriving = h * slopes()[piece + 1];
    const double square = 3 * rise - 2 * leaving - arriving;
    const double cube = leaving + arriving - 2 * rise;
    return h * u * (ys()[piece] + u * (leaving / 2 + u * (square / 3 + u * (cube / 4))));
}

/// From the end outwards to a place beyond it.
double NaturalFunction::integralBeyond(const Place& place) const {
    const bool before = place.beyond < 0;
    return place.beyond * ((before ? ys().front() : ys().back()) +
                           place.beyond / 2 * (before ? slopes().front() : slopes().back()));
}

double NaturalFunction::integral(double a, double b) const {
    if (b < a) {
        return -integral(b, a);
    }
    const Place from = locate(a);
    const Place to = locate(b);
    double sum = integralBeyond(to) - integralBeyond(from);
    sum += integralWithin(to.piece, to.x) - integralWithin(from.piece, from.x);
    for (std::size_t i = from.piece; i < to.piece; ++i) {
        sum += integralWithin(i, xs()[i + 1]);
    }
    return std::ldexp(sum, xExponent_ + yExponent_);
}

} // namespace splineloft
