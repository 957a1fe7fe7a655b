// Barsky's beta-spline: at each joint the speed jumps by the ratio bias, and direction and
// curvature are continuous whatever bias and tension are.
//
// With values of bias and tension at each control point the spline is rational in u.
#include "core/spline/algebra/bernstein.h"
#include "core/spline/family.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace splineloft::families {
namespace {

/// delta times the Bézier points of a piece, as weights of its four points, once bias and tension
/// are known; delta is what the weights of each Bézier point sum to. They are polynomials in bias
/// and tension, so that numbers can stand for both, or polynomials in u.
template <class Number> struct Recipe {
    using Row = std::array<Number, 4>;
    std::array<Row, 4> weights; ///< of the Bézier points
    Number delta;

    Recipe(const Number& b1, const Number& b2, const Number& one) {
        const Number zero = 0.0 * one;
        const Number square = b1 * b1;
        const Number cube = b1 * square;
        const Number first = 2.0 * cube;
        const Number middle = b2 + 4.0 * square + 4.0 * b1;
        const Number last = 2.0 * one;
        delta = first + middle + last;
        // The inner Bézier points lie on the leg between the middle two points.
        const Number nearStart = last + 2.0 * b1;
        const Number nearEnd = first + 2.0 * square;
        weights = {Row{first, middle, last, zero}, Row{zero, delta - nearStart, nearStart, zero},
                   Row{zero, nearEnd, delta - nearEnd, zero}, Row{zero, first, middle, last}};
    }
};

/// A polynomial in Bernstein form, of fixed degree, with the arithmetic that a recipe needs. A
/// product of two has the degree of both together; sums raise the lower one.
struct Polynomial {
    Bernstein coefficients;

    friend Polynomial operator*(double a, const Polynomial& p) {
        return {sum({Bernstein(p.coefficients.size(), 0.0)}, p.coefficients, a)};
    }
    friend Polynomial operator*(const Polynomial& a, const Polynomial& b) {
        return {product(a.coefficients, b.coefficients)};
    }
    friend Polynomial operator+(const Polynomial& a, const Polynomial& b) { return added(a, b, 1); }
    friend Polynomial operator-(const Polynomial& a, const Polynomial& b) {
        return added(a, b, -1);
    }

  private:
    static Polynomial added(const Polynomial& a, const Polynomial& b, double factor) {
        const int degree =
            static_cast<int>(std::max(a.coefficients.size(), b.coefficients.size())) - 1;
        return {sum(elevated(a.coefficients, degree), elevated(b.coefficients, degree), factor)};
    }
};

// Shaped: bias and tension go from one joint's value to the next by h(u) = 10u^3 - 15u^4 + 6u^5, of
// degree 5; delta is of degree 3 in the bias; with the cubic Bernstein polynomials that makes 18.
constexpr int shapedDegree = 18;

struct Beta {
    template <Blendable T>
    static void piece(const Input<T>& input, std::size_t i, std::span<T> bezier) {
        if (input.layout.form == Form::rational) {
            shapedPiece(input, i, bezier);
            return;
        }
        const double b1 = input.parameters[0];
        const Recipe<double> recipe(b1, input.parameters[1], 1.0);
        // A power of two first brings the weights to the size of 1: products with the farthest
        // points stay finite, and every digit as it is.
        const double scale = std::ldexp(1.0, -std::ilogb(recipe.delta));
        const double over = 1 / (scale * recipe.delta);
        const auto p = input.points.subspan(i, 4);
        for (std::size_t j = 0; j < 4; ++j) {
            std::array<double, 4> weights = recipe.weights[j];
            std::ranges::transform(weights, weights.begin(), [=](double w) { return scale * w; });
            bezier[j] = over * (weights[0] * p[0] + weights[1] * p[1] + weights[2] * p[2] +
                                weights[3] * p[3]);
        }
    }

    /// Continuously shaped (Barsky and Beatty 1983): each joint has the bias and tension of the
    /// control point nearest to it.
    template <Blendable T>
    static void shapedPiece(const Input<T>& input, std::size_t i, std::span<T> bezier) {
        const Recipe<Polynomial> recipe(between(input, 0, i), between(input, 1, i), {{1.0}});
        // Everything is divided by the largest weight, which projection takes out again.
        const double size = std::ranges::max(recipe.delta.coefficients);
        std::ranges::fill(bezier, T{});
        for (std::size_t j = 0; j < 4; ++j) {
            Polynomial cubic{{0, 0, 0, 0}}; // Bernstein's polynomial number j
            cubic.coefficients[j] = 1 / size;
            for (std::size_t k = 0; k < 4; ++k) {
                const auto shares =
                    elevated((cubic * recipe.weights[j][k]).coefficients, shapedDegree);
                for (std::size_t r = 0; r < bezier.size(); ++r) {
                    bezier[r] = bezier[r] + shares[r] * input.points[i + k];
                }
            }
        }
    }

    /// A parameter on the way from the joint near the second point of the window to the next one.
    template <Blendable T>
    static Polynomial between(const Input<T>& input, std::size_t parameter, std::size_t i) {
        const double from = input.parameterAt(parameter, i + 1);
        const double to = input.parameterAt(parameter, i + 2);
        return {{from, from, from, to, to, to}}; // h has the coefficients 0, 0, 0, 1, 1, 1
    }
};

} // namespace

Family beta() {
    return localFamily<Beta>({
        .id = "beta",
        .name = "Beta-spline",
        .summary =
            "A B-spline with bias and tension: direction and curvature stay continuous, speed "
            "may jump.",
        .source = "Barsky 1981 · Barsky and Beatty 1983",
        .parameters = {{.key = "bias",
                        .label = "Bias",
                        .symbol = "β₁",
                        .least = 1e-3,
                        .most = 1e3,
                        .sliderLeast = 1.0 / 16,
                        .sliderMost = 16,
                        .neutral = 1,
                        .scale = Scale::ratio,
                        .meaning =
                            "speed after a joint ÷ speed before it; 1 is neutral, 1/β₁ mirrors",
                        .local = true},
                       {.key = "tension",
                        .label = "Tension",
                        .symbol = "β₂",
                        .least = 0,
                        .most = 1e6,
                        .sliderLeast = 0,
                        .sliderMost = 50,
                        .neutral = 0,
                        .scale = Scale::linear,
                        .meaning = "0 is neutral; larger clings to the polygon",
                        .local = true}},
        .ends = {Ends::doubled, Ends::open, Ends::reflected},
        .layout =
            [](const Extent& extent) {
                return extent.local ? Layout{shapedDegree, 4, 1, 1, Form::rational}
                                    : fourPointCubic(extent);
            },
    });
}

} // namespace splineloft::families
