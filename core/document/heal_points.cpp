#include "core/document/heal.h"
#include "core/spline/problem.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace splineloft {
namespace {

constexpr int samplesPerPiece = 12;
// What moving a control point costs beside coming nearer: so little that it only keeps those at
// home that hardly pull on the curve.
constexpr double reluctance = 1e-5;
// Rounds of fitting where knots follow the points, so that the curve is not quite linear in them.
constexpr int rounds = 4;

/// From parameter values of a curve with gaps to those of the curve without: straight from control
/// point to control point that both have.
class Correspondence {
  public:
    Correspondence(const Curve& old, const Curve& left, const std::vector<std::size_t>& kept) {
        const KnotLine& oldLine = lineOf(old, oldPieces_);
        const KnotLine& line = lineOf(left, leftPieces_);
        const bool sameRange = oldLine.start() == line.start() && oldLine.end() == line.end();
        if (sameRange) { // one piece, or knots of its own: the parameter itself is what is kept
            pairs_ = {{line.start(), line.start()}, {line.end(), line.end()}};
            return;
        }
        const auto before = abscissae(old);
        const auto after = abscissae(left);
        for (std::size_t i = 0; i < kept.size(); ++i) {
            add(after[i], before[kept[i]]);
        }
        if (old.closed) { // once more, a turn later
            period_ = oldLine.end() - oldLine.start();
            start_ = oldLine.start();
            add(after[0] + line.end() - line.start(), before[kept[0]] + period_);
        }
    }

    /// Which spot of the old curve belongs to t; nothing beyond the points that both have.
    std::optional<Spot> at(double t) const {
        const auto next = std::ranges::upper_bound(pairs_, t, {}, &Pair::left);
        double old = pairs_.back().old;
        if (next == pairs_.begin()) {
            if (t < next->left) {
                return std::nullopt;
            }
        } else if (next != pairs_.end()) {
            const auto& from = *(next - 1);
            old = std::lerp(from.old, next->old, (t - from.left) / (next->left - from.left));
        } else if (t > pairs_.back().left) {
            return std::nullopt;
        }
        if (period_ > 0) {
            old -= std::floor((old - start_) / period_) * period_;
        }
        return oldPieces_.knots().locate(old);
    }
    const Pieces& oldPieces() const { return oldPieces_; }
    const Pieces& leftPieces() const { return leftPieces_; }

  private:
    struct Pair {
        double left, old;
    };

    static const KnotLine& lineOf(const Curve& curve, Pieces& pieces) {
        pieces = piecesOf(curve);
        return pieces.knots();
    }
    void add(double left, double old) {
        if (pairs_.empty() || left > pairs_.back().left) {
            pairs_.push_back({left, old});
        }
    }

    Pieces oldPieces_, leftPieces_;
    std::vector<Pair> pairs_;
    double period_ = 0, start_ = 0;
};

/// Which controls may move, by their numbers in the blends: those nearest to the gaps.
std::vector<std::size_t> freeControls(const Curve& old, const Curve& left,
                                      const std::vector<std::size_t>& kept) {
    const auto n = kept.size();
    const bool tangents = familyOf(old).usesTangents;
    const auto degree = static_cast<std::size_t>(layoutOf(left).degree);
    const std::size_t reach = tangents ? 1 : std::clamp<std::size_t>(degree / 2 + 1, 2, 6);
    std::set<std::size_t> free;
    const auto offer = [&](std::size_t control) {
        const bool isEnd = !old.closed && (control == 0 || control + 1 == n);
        if (tangents) {
            free.insert(n + control);
        } else if (!isEnd) {
            free.insert(control);
        }
    };
    for (std::size_t i = 0; i < n; ++i) {
        const bool isLast = i + 1 == n;
        if ((isLast && !old.closed) || kept[(i + 1) % n] == (kept[i] + 1) % old.points.size()) {
            continue; // no gap after this one
        }
        for (std::size_t k = 0; k < std::min(reach, n); ++k) {
            if (old.closed || k <= i) {
                offer((i + n - k) % n);
            }
            if (old.closed || i + 1 + k < n) {
                offer((i + 1 + k) % n);
            }
        }
    }
    return {free.begin(), free.end()};
}

/// One equation: shares of the unknowns, and the place that is missing.
struct Equation {
    std::vector<Share> shares; ///< `control` counts the unknowns
    Point missing;
};

using Unknowns = std::vector<Point>;

Unknowns zeros(std::size_t count, int dimension) {
    return Unknowns(count, Point(dimension));
}

double scalarProduct(const Unknowns& a, const Unknowns& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        sum += dot(a[i], b[i]);
    }
    return sum;
}

/// Conjugate gradients for least squares (Hestenes and Stiefel 1952).
Unknowns leastSquares(const std::vector<Equation>& equations, std::size_t count, int dimension) {
    Unknowns solution = zeros(count, dimension);
    std::vector<Point> residuals;
    for (const auto& equation : equations) {
        residuals.push_back(equation.missing);
    }
    const auto gathered = [&] {
        Unknowns sums = zeros(count, dimension);
        for (std::size_t i = 0; i < equations.size(); ++i) {
            for (const auto& share : equations[i].shares) {
                sums[share.control] += share.weight * residuals[i];
            }
        }
        return sums;
    };
    Unknowns gradient = gathered();
    Unknowns direction = gradient;
    double size = scalarProduct(gradient, gradient);
    const double enough = 1e-26 * size;
    for (std::size_t step = 0; step < 4 * count * static_cast<std::size_t>(dimension) + 8; ++step) {
        std::vector<Point> images;
        double square = 0;
        for (const auto& equation : equations) {
            Point image(dimension);
            for (const auto& share : equation.shares) {
                image += share.weight * direction[share.control];
            }
            square += dot(image, image);
            images.push_back(image);
        }
        if (!(square > 0) || !(size > enough)) {
            break;
        }
        const double length = size / square;
        for (std::size_t i = 0; i < count; ++i) {
            solution[i] += length * direction[i];
        }
        for (std::size_t i = 0; i < residuals.size(); ++i) {
            residuals[i] -= length * images[i];
        }
        gradient = gathered();
        const double next = scalarProduct(gradient, gradient);
        for (std::size_t i = 0; i < count; ++i) {
            direction[i] = gradient[i] + (next / size) * direction[i];
        }
        size = next;
    }
    return solution;
}

std::vector<Equation> equationsOf(const Curve& left, const Correspondence& correspondence,
                                  const std::vector<std::size_t>& free) {
    std::map<std::size_t, std::size_t> number;
    for (const auto control : free) {
        number.emplace(control, number.size());
    }
    const Pieces& pieces = correspondence.leftPieces();
    const BlendPieces blends = blendsOf(left);
    const auto isFree = [&](const Share& share) { return number.contains(share.control); };
    std::vector<Equation> equations;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const bool moves = std::ranges::any_of(blends[i], [&](const Blend& blend) {
            return std::ranges::any_of(blend.shares(), isFree);
        });
        for (int k = 0; moves && k <= samplesPerPiece; ++k) {
            const Spot spot{i, static_cast<double>(k) / samplesPerPiece};
            const auto old = correspondence.at(pieces.knots().parameter(spot));
            if (!old) {
                continue;
            }
            Equation equation{{},
                              correspondence.oldPieces().position(*old) - pieces.position(spot)};
            const Blend basis = blends.basis(spot);
            for (const auto& share : basis.shares()) {
                if (isFree(share)) {
                    equation.shares.push_back({number.at(share.control), share.weight});
                }
            }
            equations.push_back(std::move(equation));
        }
    }
    for (std::size_t i = 0; i < free.size(); ++i) {
        equations.push_back({{{i, reluctance}}, Point(left.points.dimension())});
    }
    return equations;
}

} // namespace

Curve withFittedPoints(const Curve& old, const Curve& left, const std::set<std::size_t>& gone) {
    std::vector<std::size_t> kept;
    for (std::size_t i = 0; i < old.points.size(); ++i) {
        if (!gone.contains(i)) {
            kept.push_back(i);
        }
    }
    const auto n = kept.size();
    const auto free = freeControls(old, left, kept);
    Curve result = left;
    for (int round = 0; !free.empty() && round < (knotsFollowPoints(left) ? rounds : 1); ++round) {
        const Correspondence correspondence(old, result, kept);
        const auto moves = leastSquares(equationsOf(result, correspondence, free), free.size(),
                                        old.points.dimension());
        for (std::size_t i = 0; i < free.size(); ++i) {
            auto& table = free[i] < n ? result.points : result.tangents;
            table.set(free[i] % n, table.at(free[i] % n) + moves[i]);
        }
        if (problemOf(result)) {
            return left;
        }
    }
    return result;
}

} // namespace splineloft
