#include "core/spline/nearest.h"

#include <algorithm>
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
            const double x = piece.coordinates[static_cast<std::size_t>(i * piece.dimension + c)];
            low = std::min(low, x);
            high = std::max(high, x);
        }
        outside[c] = std::max({low - place[c], 0.0, place[c] - high});
    }
    return norm(outside);
}

/// Bernstein coefficients of the pull: half the derivative by u of the squared distance, which is
/// zero where the way to the place is square to the curve. A polynomial of degree 2 degree - 1;
/// here divided by the sizes of its two factors, so that it neither overflows nor vanishes.
std::vector<double> pullOf(const Piece& piece, const Point& place) {
    const int d = piece.degree;
    std::vector<Point> ways, steps;
    double farthest = 0, longest = 0;
    for (int i = 0; i <= d; ++i) {
        ways.push_back(piece.bezierPoint(i) - place);
        farthest = std::max(farthest, norm(ways.back()));
    }
    for (std::size_t i = 0; i + 1 < ways.size(); ++i) {
        steps.push_back(ways[i + 1] - ways[i]);
        longest = std::max(longest, norm(steps.back()));
    }
    std::vector<double> pull(static_cast<std::size_t>(2 * d), 0.0);
    if (farthest < std::numeric_limits<double>::min() ||
        longest < std::numeric_limits<double>::min()) {
        return pull;
    }
    for (auto& way : ways) {
        way *= 1 / farthest;
    }
    for (auto& step : steps) {
        step *= 1 / longest;
    }
    // The product of Bernstein polynomials number i and j is number i + j of the sum of the
    // degrees, times binomial(d, i) binomial(d - 1, j) / binomial(2d - 1, i + j).
    double first = 1; // the factor for j = 0
    for (int i = 0; i <= d; ++i) {
        double factor = first;
        for (int j = 0; j < d; ++j) {
            pull[static_cast<std::size_t>(i + j)] +=
                factor * dot(ways[static_cast<std::size_t>(i)], steps[static_cast<std::size_t>(j)]);
            factor *= static_cast<double>(d - 1 - j) / (j + 1) * (i + j + 1) / (2 * d - 1 - i - j);
        }
        first *= static_cast<double>(d - i) / (2 * d - 1 - i);
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
