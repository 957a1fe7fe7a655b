#include "core/spline/shape/turning.h"

#include "core/spline/algebra/rounded.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace splineloft {
namespace {

// Speed that counts as none, relative to the largest speed that the piece's legs could give it.
constexpr double slowest = 1e-9;

LocalPiece seenFromItsStart(const Piece& piece) {
    return localPiece(piece, piece.bezierPoint(0));
}

Rounded cross(const Rounded& ax, const Rounded& ay, const Rounded& bx, const Rounded& by) {
    return sum(product(ax, by), product(ay, bx), -1);
}

/// A polynomial of the sign of the curvature: P' x P'', times the cube of the weight.
Rounded turningOf(const LocalPiece& piece) {
    const Rounded& x = piece.coordinates[0];
    const Rounded& y = piece.coordinates[1];
    const Rounded x1 = derivative(x), y1 = derivative(y);
    const Rounded x2 = derivative(x1), y2 = derivative(y1);
    if (piece.form == Form::polynomial) {
        return cross(x1, y1, x2, y2);
    }
    const Rounded& w = piece.weight;
    const Rounded w1 = derivative(w), w2 = derivative(w1);
    return sum(sum(product(w, cross(x1, y1, x2, y2)), product(x, cross(y1, w1, y2, w2))),
               product(y, cross(x1, w1, x2, w2)), -1);
}

/// The squared speed, times the fourth power of the weight.
Rounded squaredSpeedOf(const LocalPiece& piece) {
    Rounded squared;
    for (int c = 0; c < static_cast<int>(piece.coordinates.size()); ++c) {
        const Rounded velocity = piece.velocity(c);
        const Rounded share = product(velocity, velocity);
        squared = c == 0 ? share : sum(squared, share);
    }
    return squared;
}

/// Zeros at which the polynomial has different signs before and after.
struct Crossing {
    double u;
    int signBefore, signAfter;
};

/// All zeros, with the signs on both sides; at 0 and 1 there is one side only, the other is 0.
std::vector<Crossing> crossingsOf(const Rounded& polynomial) {
    std::vector<Crossing> found;
    const auto roots = polynomial.roots();
    for (std::size_t i = 0; i < roots.size(); ++i) {
        const double before = i == 0 ? 0 : roots[i - 1];
        const double after = i + 1 == roots.size() ? 1 : roots[i + 1];
        found.push_back({roots[i], roots[i] > 0 ? polynomial.signAt(0.5 * (before + roots[i])) : 0,
                         roots[i] < 1 ? polynomial.signAt(0.5 * (roots[i] + after)) : 0});
    }
    return found;
}

/// Follows the side to which a curve turns, and notes where it changes.
class SideWatch {
  public:
    /// From `spot` on the curve turns to this side (0: to none).
    void turnsFrom(Spot spot, int side) {
        if (side == 0) {
            return;
        }
        if (first_ == 0) {
            first_ = side;
        }
        if (side_ * side < 0) {
            changes_.push_back(spot);
        }
        side_ = side;
    }
    /// The curve ends where it started.
    void closes() {
        if (first_ * side_ < 0) {
            changes_.insert(changes_.begin(), Spot{0, 0});
        }
    }
    std::vector<Spot> take() { return std::move(changes_); }

  private:
    std::vector<Spot> changes_;
    int first_ = 0, side_ = 0;
};

bool endsWhereItStarts(const Pieces& pieces) {
    const Point start = pieces.position({0, 0});
    const Point end = pieces.position({pieces.size() - 1, 1});
    double largest = 0;
    for (const double x : start.coordinates()) {
        largest = std::max(largest, std::abs(x));
    }
    return distance(start, end) <= 64 * std::numeric_limits<double>::epsilon() * largest;
}

/// Whether the curve stands still at u.
bool standsStill(const LocalPiece& piece, double u) {
    double largest = 0, rounding = 0;
    Point velocity(static_cast<int>(piece.coordinates.size()));
    for (int c = 0; c < velocity.dimension(); ++c) {
        const Rounded own = piece.velocity(c);
        velocity[c] = valueAt(own.coefficients, u);
        rounding = std::max(rounding, own.rounding);
        for (const double x : own.coefficients) {
            largest = std::max(largest, std::abs(x));
        }
    }
    return norm(velocity) <= std::max(slowest * largest, 2 * rounding);
}

bool moves(const LocalPiece& piece) {
    for (int c = 0; c < static_cast<int>(piece.coordinates.size()); ++c) {
        if (!piece.velocity(c).isZero()) {
            return true;
        }
    }
    return false;
}

} // namespace

std::vector<Spot> inflections(const Pieces& pieces) {
    if (pieces.empty() || pieces.dimension() != 2) {
        return {};
    }
    SideWatch watch;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const Rounded turning = scaled(turningOf(seenFromItsStart(pieces[i])));
        if (turning.isZero()) {
            continue;
        }
        const auto zeros = crossingsOf(turning);
        watch.turnsFrom({i, 0}, turning.signAt(zeros.empty() ? 0.5 : 0.5 * zeros.front().u));
        for (const auto& zero : zeros) {
            watch.turnsFrom({i, zero.u}, zero.signAfter);
        }
    }
    if (endsWhereItStarts(pieces)) {
        watch.closes();
    }
    return watch.take();
}

std::vector<Spot> cusps(const Pieces& pieces) {
    std::vector<Spot> spots;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const LocalPiece local = seenFromItsStart(pieces[i]);
        if (!moves(local)) {
            continue;
        }
        std::vector<double> slow = {0};
        std::ranges::copy(scaled(derivative(squaredSpeedOf(local))).roots(),
                          std::back_inserter(slow));
        slow.push_back(1);
        double last = -1; // two zeros next to each other are the same standstill
        for (const double u : slow) {
            if (u - last <= slowest || !standsStill(local, u)) {
                continue;
            }
            last = u;
            const bool atJoint = u == 0 && !spots.empty() && spots.back() == Spot{i - 1, 1};
            if (atJoint) {
                spots.pop_back();
            }
            spots.push_back({i, u});
        }
        if (!spots.empty() && spots.back() == Spot{i, 1} && i + 1 < pieces.size() &&
            moves(seenFromItsStart(pieces[i + 1]))) {
            spots.back() = {i + 1, 0};
        }
    }
    spots.erase(std::unique(spots.begin(), spots.end()), spots.end());
    return spots;
}

std::vector<Spot> vertices(const Pieces& pieces) {
    std::vector<Spot> spots;
    for (std::size_t i = 0; pieces.dimension() == 2 && i < pieces.size(); ++i) {
        const LocalPiece local = seenFromItsStart(pieces[i]);
        const Rounded turning = scaled(turningOf(local));
        const Rounded squared = scaled(squaredSpeedOf(local));
        if (turning.isZero() || squared.isZero()) {
            continue;
        }
        // Curvature is turning * weight^3 / squared^(3/2); this is its derivative's numerator.
        Rounded rising = derivative(turning);
        if (local.form == Form::rational) {
            rising =
                sum(product(rising, local.weight), product(turning, derivative(local.weight)), 3);
        }
        Rounded falling = product(turning, derivative(squared));
        if (local.form == Form::rational) {
            falling = product(falling, local.weight);
        }
        const Rounded slope = scaled(sum(product(rising, squared), falling, -1.5));
        for (const auto& zero : crossingsOf(slope)) {
            if (zero.signBefore * zero.signAfter < 0 && !standsStill(local, zero.u)) {
                spots.push_back({i, zero.u});
            }
        }
    }
    return spots;
}

} // namespace splineloft
