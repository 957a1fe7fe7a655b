// Natural cubic spline, the draftsman's lath: through every point with continuous second
// derivatives, which vanish at free ends; closed, it is periodic. Every point moves all of it.
#include "core/spline/families/hermite_form.h"
#include "core/spline/families/tridiagonal.h"
#include "core/spline/family.h"

#include <algorithm>
#include <cmath>
#include <concepts>
#include <vector>

namespace splineloft::families {
namespace {

/// The equations of one curve: the second derivatives at the joints, one row a joint:
/// h[i-1] M[i-1] + 2 (h[i-1] + h[i]) M[i] + h[i] M[i+1] = 6 (slope[i] - slope[i-1]).
template <Blendable T> class Equations {
  public:
    explicit Equations(const Input<T>& input) : pieces_(input.points.size() - 1) {
        // The unit of the parameter does not change the curve. One near the length of the whole, a
        // power of 2 so that nothing is rounded, keeps squares of intervals far from overflow.
        const double whole = input.knots[pieces_] - input.knots[0];
        const double unit = whole > 0 ? std::exp2(std::ilogb(whole)) : 1;
        for (std::size_t i = 0; i < pieces_; ++i) {
            const double h = (input.knots[i + 1] - input.knots[i]) / unit;
            const T chord = input.points[i + 1] - input.points[i];
            intervals_.push_back(h);
            // Where points coincide and the interval is nothing, the limit of the slope is rest.
            slopes_.push_back(h > 0 ? (1 / h) * chord : T{});
        }
    }

    double interval(std::size_t i) const { return intervals_[i]; }

    /// Second derivatives at the pieces + 1 points of an open curve.
    std::vector<T> natural() const { return between(bends(1, pieces_ - 1)); }

    /// Second derivatives of a closed curve, the first repeated at the end.
    std::vector<T> periodic() const {
        return around(6.0 * (slopes_[0] - slopes_[pieces_ - 1]), bends(1, pieces_ - 1));
    }

    /// What the points of the curve weigh in the second derivative at a joint. The equations are
    /// symmetric, so that one solution, with 1 at this joint for right sides, is the row of their
    /// inverse.
    std::vector<double> weightsAt(std::size_t joint, bool closed) const {
        std::vector<double> inner(pieces_ - 1);
        const bool isInner = joint > 0 && joint < pieces_;
        if (isInner) {
            inner[joint - 1] = 1;
        }
        const double first = isInner || !closed ? 0 : 1;
        const auto row = closed ? around(first, inner) : between(inner);
        std::vector<double> weights(pieces_ + 1);
        for (std::size_t i = 0; i < pieces_; ++i) {
            const double ofSlope = 6 * (row[i] - row[i + 1]);
            const double ofPoint = intervals_[i] > 0 ? 1 / intervals_[i] * ofSlope : 0;
            weights[i] -= ofPoint;
            weights[i + 1] += ofPoint;
        }
        return weights;
    }

  private:
    /// Solves for an open curve: right sides of the inner joints.
    template <Blendable R> std::vector<R> between(const std::vector<R>& inner) const {
        std::vector<R> second(pieces_ + 1);
        if (pieces_ > 1) {
            std::ranges::move(solve<R>(1, inner), second.begin() + 1);
        }
        return second;
    }

    /// Solves for a closed curve. The rows form a ring: it is cut at joint 0, whose M is found last
    /// from its own row.
    template <Blendable R>
    std::vector<R> around(const R& first, const std::vector<R>& others) const {
        const auto inner = pieces_ - 1;
        const double before = intervals_[pieces_ - 1];
        const double after = intervals_[0];
        std::vector<double> unit(inner); // what one unit of M[0] adds to the rows beside it,
        unit.front() -= after;
        unit.back() -= before;
        std::vector<double> pull(pieces_ + 1); // and so to all others
        std::ranges::move(solve<double>(1, unit), pull.begin() + 1);
        std::vector<R> second(pieces_ + 1);
        std::ranges::move(solve<R>(1, others), second.begin() + 1);
        const double diagonal = diagonalOf(0) + before * pull[inner] + after * pull[1];
        const R right = first - before * second[inner] - after * second[1];
        const R cut = (1 / diagonal) * right;
        for (std::size_t i = 1; i <= inner; ++i) {
            second[i] = second[i] + pull[i] * cut;
        }
        second[0] = cut;
        second[pieces_] = cut;
        return second;
    }

    double previous(std::size_t joint) const { return intervals_[(joint + pieces_ - 1) % pieces_]; }
    /// Where neither neighbouring piece has an interval the row is empty: M is 0 there.
    double diagonalOf(std::size_t joint) const {
        const double sum = previous(joint) + intervals_[joint];
        return sum > 0 ? 2 * sum : 1;
    }

    /// Right sides of `count` rows: how much the chords turn there.
    std::vector<T> bends(std::size_t first, std::size_t count) const {
        std::vector<T> right(count);
        for (std::size_t k = 0; k < count; ++k) {
            right[k] = 6.0 * (slopes_[first + k] - slopes_[first + k - 1]);
        }
        return right;
    }

    /// Solves the rows from `first` on, as many as there are right sides.
    template <Blendable R>
    std::vector<R> solve(std::size_t first, const std::vector<R>& right) const {
        const auto count = right.size();
        std::vector<double> diagonal(count);
        for (std::size_t k = 0; k < count; ++k) {
            diagonal[k] = diagonalOf(first + k);
        }
        const auto intervals = std::span(intervals_);
        return solveTridiagonal<R>({intervals.subspan(first - 1, count), diagonal,
                                    intervals.subspan(first, count), right});
    }

    std::size_t pieces_;
    std::vector<double> intervals_;
    std::vector<T> slopes_;
};

/// Recipes for the second derivatives at the start and the end of pieces, one joint after another.
class SecondRecipes {
  public:
    explicit SecondRecipes(const Input<Blend>& input)
        : input_(input), equations_(noPlaces(input)) {}

    double interval(std::size_t i) const { return equations_.interval(i); }
    Blend at(std::size_t joint) const {
        return weightedSum(equations_.weightsAt(joint, input_.closed), input_.points);
    }

  private:
    /// The equations need the knots alone.
    Equations<double> noPlaces(const Input<Blend>& input) {
        places_.resize(input.points.size());
        Input<double> same{places_,          {},          input.knots,   input.intervals,
                           input.parameters, input.local, input.windows, input.layout,
                           input.closed};
        return Equations<double>(same);
    }

    const Input<Blend>& input_;
    std::vector<double> places_;
    Equations<double> equations_;
};

struct Natural {
    template <Blendable T>
    static void pieces(const Input<T>& input, Range range, std::span<T> bezier) {
        const auto fill = [&](std::size_t i, double h, const T& before, const T& after) {
            const T chord = input.points[i + 1] - input.points[i];
            const double sixth = h * h / 6;
            hermiteToBezier<T>(input.points[i], chord - sixth * (2.0 * before + after),
                               chord + sixth * (before + 2.0 * after), input.points[i + 1],
                               bezier.subspan(4 * (i - range.first), 4));
        };
        if constexpr (std::same_as<T, Blend>) {
            const SecondRecipes recipes(input);
            Blend before = recipes.at(range.first);
            for (std::size_t i = range.first; i < range.last; ++i) {
                Blend after = recipes.at(i + 1);
                fill(i, recipes.interval(i), before, after);
                before = std::move(after);
            }
        } else {
            const Equations<T> equations(input);
            const auto second = input.closed ? equations.periodic() : equations.natural();
            for (std::size_t i = range.first; i < range.last; ++i) {
                fill(i, equations.interval(i), second[i], second[i + 1]);
            }
        }
    }
};

} // namespace

Family natural() {
    return globalFamily<Natural>({
        .id = "natural",
        .name = "Natural",
        .summary = "Passes through every point as a springy lath would: C², but every point moves "
                   "the whole curve.",
        .source = "Schoenberg 1946 · Ahlberg, Nilson and Walsh 1967",
        .parameters = {{.key = "alpha",
                        .label = "Alpha",
                        .symbol = "α",
                        .least = 0,
                        .most = 1,
                        .sliderLeast = 0,
                        .sliderMost = 1,
                        .neutral = 0,
                        .scale = Scale::linear,
                        .meaning =
                            "0 is uniform, ½ centripetal, 1 spaces the knots by chord length"}},
        .ends = {Ends::none},
        .spacing = Spacing::chord,
        .layout = twoPointCubic,
    });
}

} // namespace splineloft::families
