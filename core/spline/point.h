// Places: one point of up to sixteen coordinates, and a table of many.
#pragma once

#include <array>
#include <cstddef>
#include <initializer_list>
#include <span>
#include <vector>

namespace splineloft {

/// Most coordinates a point may have (position, orientation and ten more).
inline constexpr int maxDimension = 16;

/// A place or a displacement: 1 to 16 coordinates, held in place without allocation. (A rational
/// place has its weight as one more.)
class Point {
  public:
    Point() = default;
    /// The origin of a space of `dimension` coordinates.
    explicit Point(int dimension) : dimension_(dimension) {}
    Point(std::initializer_list<double> coordinates);
    explicit Point(std::span<const double> coordinates);

    int dimension() const { return dimension_; }
    double operator[](int coordinate) const {
        return values_[static_cast<std::size_t>(coordinate)];
    }
    double& operator[](int coordinate) { return values_[static_cast<std::size_t>(coordinate)]; }
    std::span<const double> coordinates() const {
        return {values_.data(), static_cast<std::size_t>(dimension_)};
    }
    bool operator==(const Point& other) const;

    Point& operator+=(const Point& other);
    Point& operator-=(const Point& other);
    Point& operator*=(double factor);

  private:
    std::array<double, maxDimension + 1> values_{}; // one more for the weight of rational points
    int dimension_ = 0;
};

Point operator+(Point a, const Point& b);
Point operator-(Point a, const Point& b);
Point operator*(double factor, Point p);

/// Scalar product of the coordinates.
double dot(const Point& a, const Point& b);
/// Euclidean length; neither overflows nor underflows before the result does.
double norm(const Point& p);
/// The same direction with length 1, however short p is; the origin stays the origin.
Point unitVector(const Point& p);
/// Whether every coordinate is a finite number.
bool isFinite(const Point& p);
/// Distance of two places.
double distance(const Point& a, const Point& b);

/// A table of points, one row a point, all with the same number of coordinates.
class Points {
  public:
    explicit Points(int dimension = 2) : dimension_(dimension) {}
    /// One inner list a point; all must be equally long.
    Points(std::initializer_list<std::initializer_list<double>> rows);

    int dimension() const { return dimension_; }
    std::size_t size() const { return dimension_ > 0 ? values_.size() / stride() : 0; }
    bool empty() const { return values_.empty(); }
    /// The coordinates of point `index`.
    std::span<const double> operator[](std::size_t index) const {
        return std::span(values_).subspan(index * stride(), stride());
    }
    Point at(std::size_t index) const { return Point((*this)[index]); }

    void set(std::size_t index, const Point& place);
    void insert(std::size_t before, const Point& place);
    void erase(std::size_t index);
    void append(const Point& place) { insert(size(), place); }
    void reserve(std::size_t count) { values_.reserve(count * stride()); }

    /// All coordinates, row after row.
    std::span<const double> values() const { return values_; }
    bool operator==(const Points&) const = default;

  private:
    std::size_t stride() const { return static_cast<std::size_t>(dimension_); }

    int dimension_;
    std::vector<double> values_;
};

} // namespace splineloft
