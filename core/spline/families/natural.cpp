// Natural cubic spline, the draftsman's lath: through every point with continuous second
// derivatives, which vanish at free ends; closed, it is periodic. Every point moves all of it.
#include "core/spline/families/hermite_form.h"
#include "core/spline/families/tridiagonal.h"
#include "core/spline/family.h"

#include <algorithm>
#include <cmath>
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
    std::vector<T> natural() const {
        std::vector<T> second(pieces_ + 1);
        if (pieces_ > 1) {
            std::ranges::move(solve<T>(1, bends(1, pieces_ - 1)), second.begin() + 1);
        }
        return second;
    }

    /// Second derivatives of a closed curve, the first repeated at the end. The rows form a ring:
    /// it is cut at joint 0, whose M is found last from its own row.
    std::vector<T> periodic() const {
        const auto inner = pieces_ - 1;
        const double before = intervals_[pieces_ - 1];
        const double after = intervals_[0];
        std::vector<double> unit(inner); // what one unit of M[0] adds to the rows beside it,
        unit.front() -= after;
        unit.back() -= before;
        std::vector<double> pull(pieces_ + 1); // and so to all others
        std::ranges::move(solve<double>(1, unit), pull.begin() + 1);
        std::vector<T> second(pieces_ + 1);
        std::ranges::move(solve<T>(1, bends(1, inner)), second.begin() + 1);
        const double diagonal = diagonalOf(0) + before * pull[inner] + after * pull[1];
        const T right =
            6.0 * (slopes_[0] - slopes_[pieces_ - 1]) - before * second[inner] - after * second[1];
        const T cut = (1 / diagonal) * right;
        for (std::size_t i = 1; i <= inner; ++i) {
            second[i] = second[i] + pull[i] * cut;
        }
        second[0] = cut;
        second[pieces_] = cut;
        return second;
    }

  private:
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

struct Natural {
    template <Blendable T>
    static void pieces(const Input<T>& input, Range range, std::span<T> bezier) {
        const Equations<T> equations(input);
        const auto second = input.closed ? equations.periodic() : equations.natural();
        for (std::size_t i = range.first; i < range.last; ++i) {
            const double h = equations.interval(i);
            const T chord = input.points[i + 1] - input.points[i];
            const double sixth = h * h / 6;
            hermiteToBezier<T>(input.points[i], chord - sixth * (2.0 * second[i] + second[i + 1]),
                               chord + sixth * (second[i] + 2.0 * second[i + 1]),
                               input.points[i + 1], bezier.subspan(4 * (i - range.first), 4));
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
