#include "core/spline/nearest.h"

#include "core/spline/bernstein.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace splineloft {
namespace {

/// How far `place` lies outside the box of a piece's Bézier points: no spot of it is nearer.
double distanceToHull(const Piece& piece, const Point& place) {
    Point outside(piece.dimension);
    for (int c = 0; c < piece.dimension; ++c) {
        double low = std::numeric_limits<double>::infinity();
        double high = -low;
        for (int i = 0; i <= piece.degree; ++i) {
            const double x = piece.bezierPoint(i)[c];
            low = std::min(low, x);
            high = std::max(high, x);
        }
        outside[c] = std::max({low - place[c], 0.0, place[c] - high});
    }
    return norm(outside);
}

/// Bernstein coefficients of the pull: half the derivative by u of the squared distance (times the
/// cube of the weight on a rational piece), which is zero where the way to the place is square to
/// the curve. Here divided by the sizes of its factors, so that it neither overflows nor vanishes.
Bernstein pullOf(const Piece& piece, const Point& place) {
    const bool rational = piece.form == Form::rational;
    std::vector<Bernstein> ways, steps; // one a coordinate: to the curve, and along it
    const Bernstein weight = rational ? piece.column(piece.dimension) : Bernstein{1};
    double farthest = 0, longest = 0;
    for (int c = 0; c < piece.dimension; ++c) {
        Bernstein way = piece.column(c);
        for (std::size_t i = 0; i < way.size(); ++i) {
            way[i] -= (rational ? weight[i] : 1) * place[c];
            farthest = std::max(farthest, std::abs(way[i]));
        }
        ways.push_back(std::move(way));
    }
    if (!(farthest >= std::numeric_limits<double>::min())) {
        return {0};
    }
    for (auto& way : ways) {
        std::ranges::transform(way, way.begin(), [&](double x) { return x / farthest; });
        Bernstein step = derivative(way);
        if (rational) {
            step = sum(product(step, weight), product(way, derivative(weight)), -1);
        }
        for (const double x : step) {
            longest = std::max(longest, std::abs(x));
        }
        steps.push_back(std::move(step));
    }
    if (!(longest >= std::numeric_limits<double>::min())) {
        return {0};
    }
    Bernstein pull;
    for (std::size_t c = 0; c < ways.size(); ++c) {
        std::ranges::transform(steps[c], steps[c].begin(), [&](double x) { return x / longest; });
        const Bernstein share = product(ways[c], steps[c]);
        pull = c == 0 ? share : sum(pull, share);
    }
    return pull;
}

/// Finds every minimum of the distance on a piece: the pull changes sign no more often than its
/// Bernstein coefficients do, so an interval is cut in half until they change at most once.
class Search {
  public:
    Search(const Piece& piece, const Point& place, std::size_t segment, Nearest& best)
        : piece_(piece), place_(place), segment_(segment), best_(best) {
        const auto pull = pullOf(piece, place);
        noise_ = 4 * static_cast<double>(pull.size()) * std::numeric_limits<double>::epsilon();
        consider(0);
        consider(1);
        cut(pull, 0, 1);
    }

  private:
    void consider(double u) {
        const double there = distance(piece_.position(u), place_);
        if (there < best_.distance) {
            best_ = {{segment_, u}, there};
        }
    }

    void cut(std::vector<double> pull, double low, double high) {
        int last = 0;
        int changes = 0;
        bool rises = false;
        for (const double c : pull) {
            const int sign = c > noise_ ? 1 : c < -noise_ ? -1 : 0;
            if (sign * last < 0) {
                ++changes;
                rises = sign > 0;
            }
            last = sign != 0 ? sign : last;
        }
        if (changes == 0) {
            return;
        }
        const double middle = 0.5 * (low + high);
        if (changes == 1 || cuts_ == mostCuts || !(low < middle && middle < high)) {
            if (changes > 1 || rises) {
                consider(refined(low, high));
            }
            return;
        }
        ++cuts_;
        consider(middle);
        std::vector<double> left;
        for (auto rungs = std::span(pull); !rungs.empty(); rungs = rungs.first(rungs.size() - 1)) {
            left.push_back(rungs.front());
            climb(rungs, 0.5);
        }
        cut(std::move(left), low, middle);
        cut(std::move(pull), middle, high);
    }

    /// The lowest distance between two values of u, by bisection of the pull, which is below zero
    /// before the minimum and above it after.
    double refined(double low, double high) const {
        for (double middle = 0.5 * (low + high); low < middle && middle < high;
             middle = 0.5 * (low + high)) {
            const Jet jet = piece_.jet(middle);
            const double speed = norm(jet.first);
            const double pull = speed > 0 ? dot(jet.position - place_, (1 / speed) * jet.first) : 0;
            (pull < 0 ? low : high) = middle;
        }
        return 0.5 * (low + high);
    }

    // Enough for every minimum of any ordinary piece; reached only where the distance hardly
    // changes, as around the center of an arc.
    static constexpr int mostCuts = 256;

    const Piece& piece_;
    const Point& place_;
    std::size_t segment_;
    Nearest& best_;
    double noise_ = 0;
    int cuts_ = 0;
};

} // namespace

std::optional<Nearest> nearestTo(const Pieces& pieces, const Point& place, double within) {
    Nearest best{{}, within};
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const Piece piece = pieces[i];
        if (distanceToHull(piece, place) < best.distance) {
            Search(piece, place, i, best);
        }
    }
    return best.distance < within ? std::optional(best) : std::nullopt;
}

} // namespace splineloft
