// A view of points that lie in somebody else's memory, in the layout that they have there: an array
// of glm::dvec2, of std::array<double, 3>, of one's own structs. They are read in place.
#pragma once

#include "core/spline/point.h"

#include <array>
#include <concepts>
#include <cstddef>
#include <ranges>
#include <span>
#include <type_traits>

namespace splineloft {

/// How the coordinates lie in a type of point: `Scalar` and `dimension`, without gaps. Known for
/// float and double (points on a line), for std::array, and for the fixed vectors of GLM and Eigen.
/// Other types may specialise it, or name their members to `PointsView::of`.
template <class P> struct PointLayout;

template <std::floating_point P> struct PointLayout<P> {
    using Scalar = P;
    static constexpr int dimension = 1;
};
template <std::floating_point S, std::size_t n> struct PointLayout<std::array<S, n>> {
    using Scalar = S;
    static constexpr int dimension = static_cast<int>(n);
};
template <class P>
    requires requires {
        typename P::value_type;
        { P::length() } -> std::integral;
    }
struct PointLayout<P> {
    using Scalar = typename P::value_type;
    static constexpr int dimension = static_cast<int>(P::length());
};
template <class P>
    requires requires {
        typename P::Scalar;
        { P::SizeAtCompileTime } -> std::convertible_to<int>;
    }
struct PointLayout<P> {
    using Scalar = typename P::Scalar;
    static constexpr int dimension = static_cast<int>(P::SizeAtCompileTime);
};

/// A type whose values are points, one coordinate beside the other in memory.
template <class P>
concept PointType = requires { typename PointLayout<P>::Scalar; } &&
                    (std::same_as<typename PointLayout<P>::Scalar, double> ||
                     std::same_as<typename PointLayout<P>::Scalar, float>) &&
                    PointLayout<P>::dimension >= 1 && PointLayout<P>::dimension <= maxDimension &&
                    sizeof(P) >= sizeof(typename PointLayout<P>::Scalar) *
                                     static_cast<std::size_t>(PointLayout<P>::dimension);

/// Points in somebody else's memory. Valid as long as that memory is.
class PointsView {
  public:
    PointsView() = default;
    PointsView(const Points& table)
        : PointsView(table.values().data(), table.size(), table.dimension(),
                     static_cast<std::size_t>(table.dimension()) * sizeof(double)) {}

    /// `count` points of `dimension` coordinates (1 to 16), each `stride` bytes after the one
    /// before.
    template <class Scalar>
        requires std::same_as<Scalar, double> || std::same_as<Scalar, float>
    PointsView(const Scalar* first, std::size_t count, int dimension, std::size_t stride)
        : first_(reinterpret_cast<const std::byte*>(first)), count_(count), dimension_(dimension),
          stride_(stride), isDouble_(std::same_as<Scalar, double>) {
        for (std::size_t c = 0; c < offsets_.size(); ++c) {
            offsets_[c] = c * sizeof(Scalar);
        }
    }

    /// Any row of points in one block of memory: std::vector, std::array, std::span of a PointType.
    template <std::ranges::contiguous_range Range>
        requires PointType<std::ranges::range_value_t<Range>> &&
                 (!std::same_as<std::remove_cvref_t<Range>, Points>)
    PointsView(const Range& points)
        : PointsView(reinterpret_cast<
                         const typename PointLayout<std::ranges::range_value_t<Range>>::Scalar*>(
                         std::ranges::data(points)),
                     std::ranges::size(points),
                     PointLayout<std::ranges::range_value_t<Range>>::dimension,
                     sizeof(std::ranges::range_value_t<Range>)) {}

    /// Points that are structs of one's own: `PointsView::of(cars, &Car::x, &Car::y)`.
    template <std::ranges::contiguous_range Range, class P, std::floating_point S,
              std::same_as<S P::*>... Members>
    static PointsView of(const Range& structs, S P::* first, Members... others) {
        static_assert(sizeof...(Members) < maxDimension, "points have 1 to 16 coordinates");
        const P* const begin = std::ranges::data(structs);
        const std::size_t count = std::ranges::size(structs);
        PointsView view(static_cast<const S*>(nullptr), count, 1 + int{sizeof...(Members)},
                        sizeof(P));
        view.first_ = reinterpret_cast<const std::byte*>(begin);
        const std::array members = {first, others...};
        for (std::size_t c = 0; c < members.size() && count > 0; ++c) {
            view.offsets_[c] = static_cast<std::size_t>(
                reinterpret_cast<const std::byte*>(&(begin->*members[c])) - view.first_);
        }
        return view;
    }

    std::size_t size() const { return count_; }
    bool empty() const { return count_ == 0; }
    int dimension() const { return dimension_; }

    /// All coordinates, row after row, where they are doubles that lie so in memory; else none.
    std::span<const double> rows() const {
        const auto width = static_cast<std::size_t>(dimension_);
        bool dense = isDouble_ && stride_ == width * sizeof(double);
        for (std::size_t c = 0; dense && c < width; ++c) {
            dense = offsets_[c] == c * sizeof(double);
        }
        return dense ? std::span(reinterpret_cast<const double*>(first_), count_ * width)
                     : std::span<const double>();
    }

    double operator()(std::size_t point, int coordinate) const {
        const auto* at = first_ + point * stride_ + offsets_[static_cast<std::size_t>(coordinate)];
        return isDouble_ ? *reinterpret_cast<const double*>(at)
                         : static_cast<double>(*reinterpret_cast<const float*>(at));
    }
    Point at(std::size_t point) const {
        Point place(dimension_);
        for (int c = 0; c < dimension_; ++c) {
            place[c] = (*this)(point, c);
        }
        return place;
    }

  private:
    const std::byte* first_ = nullptr;
    std::size_t count_ = 0;
    int dimension_ = 0;
    std::size_t stride_ = 0; // bytes from point to point
    bool isDouble_ = true;
    std::array<std::size_t, maxDimension> offsets_{}; // bytes from a point to its coordinates
};

} // namespace splineloft
