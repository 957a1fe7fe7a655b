// A blend is a recipe for a place: so much of this control point, so much of that one.
//
// Families are written once for anything that can be added and scaled. Given coordinates they
// answer with coordinates; given blends they answer with the recipes themselves, and from these
// the basis functions, hull, locality and affine invariance can be read off.
#pragma once

#include <concepts>
#include <cstddef>
#include <span>
#include <vector>

namespace splineloft {

/// One ingredient: how much of which control. Controls 0 .. n-1 are the control points; in a family
/// with tangents, n .. 2n-1 are the tangents.
struct Share {
    std::size_t control;
    double weight;
    bool operator==(const Share&) const = default;
};

/// A weighted sum of controls, sparse and ordered by control.
class Blend {
  public:
    Blend() = default; ///< nothing at all: zero
    /// Exactly control number `control`.
    static Blend of(std::size_t control);

    std::span<const Share> shares() const& { return shares_; }
    std::span<const Share> shares() && = delete; // it would outlive the blend
    /// The weight of one control; 0 where it does not take part.
    double weight(std::size_t control) const;
    /// Sum of the weights of the controls below `end`.
    double sumBelow(std::size_t end) const;
    bool operator==(const Blend&) const = default;

    friend Blend operator+(const Blend& a, const Blend& b);
    friend Blend operator-(const Blend& a, const Blend& b);
    friend Blend operator*(double factor, const Blend& blend);
    /// The sum of many blends, each times its weight, in one go.
    friend Blend weightedSum(std::span<const double> weights, std::span<const Blend> blends);

  private:
    std::vector<Share> shares_;
};

/// What a family can blend: a coordinate (double) or a recipe (Blend). A default value is zero.
template <class T>
concept Blendable =
    std::default_initializable<T> && std::copyable<T> && requires(const T a, const T b, double w) {
        { a + b } -> std::convertible_to<T>;
        { a - b } -> std::convertible_to<T>;
        { w* a } -> std::convertible_to<T>;
    };

/// From a (u = 0) to b (u = 1); exact at both ends.
template <Blendable T> T lerp(const T& a, const T& b, double u) {
    return (1 - u) * a + u * b;
}

} // namespace splineloft
