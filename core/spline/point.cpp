#include "core/spline/point.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace splineloft {

Point::Point(std::initializer_list<double> coordinates)
    : Point(std::span(coordinates.begin(), coordinates.size())) {}

Point::Point(std::span<const double> coordinates)
    : dimension_(static_cast<int>(coordinates.size())) {
    if (coordinates.size() > values_.size()) {
        throw std::invalid_argument("a point has at most 16 coordinates and a weight");
    }
    std::copy(coordinates.begin(), coordinates.end(), values_.begin());
}

bool Point::operator==(const Point& other) const {
    return std::ranges::equal(coordinates(), other.coordinates());
}

Point& Point::operator+=(const Point& other) {
    for (int i = 0; i < dimension_; ++i) {
        (*this)[i] += other[i];
    }
    return *this;
}

Point& Point::operator-=(const Point& other) {
    for (int i = 0; i < dimension_; ++i) {
        (*this)[i] -= other[i];
    }
    return *this;
}

Point& Point::operator*=(double factor) {
    for (int i = 0; i < dimension_; ++i) {
        (*this)[i] *= factor;
    }
    return *this;
}

Point operator+(Point a, const Point& b) {
    return a += b;
}
Point operator-(Point a, const Point& b) {
    return a -= b;
}
Point operator*(double factor, Point p) {
    return p *= factor;
}

double dot(const Point& a, const Point& b) {
    double sum = 0;
    for (int i = 0; i < a.dimension(); ++i) {
        sum += a[i] * b[i];
    }
    return sum;
}

/// Whether a sum of squares has neither overflowed nor lost what matters of it.
static bool isOrdinary(double sum) {
    return sum > 0x1p-900 && sum < 0x1p900;
}

double norm(const Point& p) {
    const double ordinary = dot(p, p);
    if (isOrdinary(ordinary)) {
        return std::sqrt(ordinary);
    }
    double largest = 0;
    for (const double x : p.coordinates()) {
        largest = std::max(largest, std::abs(x));
    }
    if (largest == 0 || !std::isfinite(largest)) {
        return largest;
    }
    double sum = 0;
    for (const double x : p.coordinates()) {
        sum += (x / largest) * (x / largest);
    }
    return largest * std::sqrt(sum);
}

Point unitVector(const Point& p) {
    const double length = norm(p);
    if (length > 0 && length < std::numeric_limits<double>::min()) {
        return unitVector(0x1p200 * p); // 1 / length would overflow
    }
    return length > 0 ? (1 / length) * p : p;
}

bool isFinite(const Point& p) {
    return std::ranges::all_of(p.coordinates(), [](double x) { return std::isfinite(x); });
}

double distance(const Point& a, const Point& b) {
    double sum = 0;
    for (int i = 0; i < a.dimension(); ++i) {
        sum += (a[i] - b[i]) * (a[i] - b[i]);
    }
    return isOrdinary(sum) ? std::sqrt(sum) : norm(a - b);
}

Points::Points(std::initializer_list<std::initializer_list<double>> rows)
    : dimension_(rows.size() == 0 ? 2 : static_cast<int>(rows.begin()->size())) {
    for (const auto& row : rows) {
        append(Point(row));
    }
}

void Points::set(std::size_t index, const Point& place) {
    if (place.dimension() != dimension_) {
        throw std::invalid_argument("all points of a table have the same number of coordinates");
    }
    std::ranges::copy(place.coordinates(),
                      values_.begin() + static_cast<std::ptrdiff_t>(index * stride()));
}

void Points::insert(std::size_t before, const Point& place) {
    if (place.dimension() != dimension_) {
        throw std::invalid_argument("all points of a table have the same number of coordinates");
    }
    const auto at = values_.begin() + static_cast<std::ptrdiff_t>(before * stride());
    const auto row = place.coordinates();
    values_.insert(at, row.begin(), row.end());
}

void Points::erase(std::size_t index) {
    const auto at = values_.begin() + static_cast<std::ptrdiff_t>(index * stride());
    values_.erase(at, at + dimension_);
}

} // namespace splineloft
