#include "core/spline/measure/motion.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace splineloft {
namespace {

constexpr double unitRoundoff = std::numeric_limits<double>::epsilon();

std::optional<double> ifFinite(double value) {
    return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

double rangeOf(const KnotLine& knots) {
    return knots.pieces() == 0 ? 0 : knots.end() - knots.start();
}

/// Which part of the whole lies before `at`; none of a whole that is nothing.
double partOf(double at, double whole) {
    return whole > 0 ? std::clamp(at / whole, 0.0, 1.0) : 0;
}

/// Whether all Bézier points of a piece lie on one line, but for rounding.
bool isStraight(const Piece& piece) {
    const Point start = piece.bezierPoint(0);
    Point longest(start.dimension());
    double size = 0;
    for (int k = 0; k <= piece.degree; ++k) {
        const Point place = piece.bezierPoint(k), way = place - start;
        size = std::max(size, norm(place));
        longest = norm(way) > norm(longest) ? way : longest;
    }
    const Point along = unitVector(longest);
    for (int k = 1; k <= piece.degree; ++k) {
        const Point way = piece.bezierPoint(k) - start;
        if (norm(way - dot(way, along) * along) > 16 * unitRoundoff * size) {
            return false;
        }
    }
    return true;
}

/// The curvature without that which is rounding alone: a straight piece has none, however slow it
/// is where it turns back, and there rounding decides its direction.
std::optional<double> curvatureWithin(const Piece& piece, const Jet& jet) {
    if (!jet.curvature || piece.dimension == 1) {
        return jet.curvature ? std::optional(0.0) : std::nullopt;
    }
    const double speed = norm(jet.first), turning = norm(jet.second);
    const double rounding = unitRoundoff * (norm(jet.position) + speed + turning);
    const bool isSure =
        std::abs(*jet.curvature) * speed * speed * speed > 1e3 * rounding * (turning + speed);
    return isSure || !isStraight(piece) ? *jet.curvature : 0;
}

} // namespace

Motion::Motion(const Pieces& pieces, const ArcLength* lengths, double duration)
    : pieces_(&pieces), lengths_(lengths), duration_(duration) {
    if (!std::isfinite(duration) || !(duration > 0)) {
        throw std::invalid_argument("the duration of a motion must be finite and above zero");
    }
}

Motion Motion::evenInParameter(const Pieces& pieces, double duration) {
    return {pieces, nullptr, duration};
}

Motion Motion::evenInLength(const Pieces& pieces, const ArcLength& lengths, double duration) {
    // Without any length there is nothing to be even in, and nothing that would tell.
    return {pieces, lengths.total() > 0 ? &lengths : nullptr, duration};
}

double Motion::timeAt(Spot spot) const {
    if (pieces_->empty()) {
        return 0;
    }
    if (lengths_ != nullptr) {
        return duration_ * partOf(lengths_->upTo(spot), lengths_->total());
    }
    const auto& knots = pieces_->knots();
    return duration_ * partOf(knots.parameter(spot) - knots.start(), rangeOf(knots));
}

Spot Motion::spotAt(double time) const {
    const double part = partOf(time, duration_);
    if (lengths_ != nullptr) {
        return lengths_->spotAt(part * lengths_->total());
    }
    const auto& knots = pieces_->knots();
    return pieces_->empty() ? Spot{} : knots.locate(lerp(knots.start(), knots.end(), part));
}

std::vector<Spot> Motion::spotsAt(std::span<const double> times) const {
    std::vector<Spot> spots;
    if (lengths_ == nullptr) {
        std::ranges::transform(times, std::back_inserter(spots),
                               [this](double time) { return spotAt(time); });
        return spots;
    }
    std::vector<double> lengths;
    std::ranges::transform(times, std::back_inserter(lengths), [this](double time) {
        return partOf(time, duration_) * lengths_->total();
    });
    return lengths_->spotsAt(lengths);
}

Movement Motion::at(Spot spot) const {
    const Jet jet = pieces_->jet(spot);
    Movement moment;
    moment.curvature = curvatureWithin((*pieces_)[spot.segment], jet);
    if (lengths_ != nullptr) {
        const double speed = lengths_->total() / duration_;
        moment.speed = ifFinite(speed);
        if (moment.curvature) {
            moment.acceleration = ifFinite(speed * (speed * std::abs(*moment.curvature)));
        }
        return moment;
    }
    const double interval = pieces_->knots().interval(spot.segment);
    if (interval > 0) {
        const double rate = rangeOf(pieces_->knots()) / interval / duration_; // du / dt
        moment.speed = ifFinite(rate * norm(jet.first));
        moment.acceleration = ifFinite(rate * (rate * norm(jet.second)));
    }
    return moment;
}

} // namespace splineloft
