#include "core/spline/length.h"

#include "core/spline/hodograph.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace splineloft {
namespace {

// 16-point Gauss-Legendre rule on [-1, 1]: the positive nodes and their weights
// (Abramowitz and Stegun 1964, table 25.4).
constexpr std::array<double, 8> nodes = {
    0.0950125098376374401853193354249581, 0.2816035507792589132304605014604961,
    0.4580167776572273863424194429835776, 0.6178762444026437484466717640487911,
    0.7554044083550030338951011948474422, 0.8656312023878317438804678977123931,
    0.9445750230732325760779884155346083, 0.9894009349916499325961541734503326};
constexpr std::array<double, 8> weights = {
    0.1894506104550684962853967232082831, 0.1826034150449235888667636679692199,
    0.1691565193950025381893120790303600, 0.1495959888165767320815017305474786,
    0.1246289712555338720524762821920164, 0.0951585116824927848099251076022462,
    0.0622535239386478928628438369943776, 0.0271524594117540948517805724560181};

// Halving a panel that holds a cusp gains two bits at least: after these cuts nothing is left.
constexpr int deepest = 40;
// Two halves that differ from the whole by less than this part of the piece's size are exact to
// rounding, because the halves are far better than the whole.
constexpr double converged = 1e-14;

/// The speed |P'(u)| on one piece. Works on the hodograph divided by its largest coordinate, so
/// that no square overflows or vanishes.
class Speed {
  public:
    explicit Speed(const Piece& piece)
        : hodograph_(hodograph(piece)), dimension_(static_cast<std::size_t>(piece.dimension)),
          width_(static_cast<std::size_t>(piece.width())) {
        coordinates_.assign(hodograph_.bezier().begin(), hodograph_.bezier().end());
        for (std::size_t i = 0; i < coordinates_.size(); ++i) {
            largest_ =
                i % width_ < dimension_ ? std::max(largest_, std::abs(coordinates_[i])) : largest_;
        }
        for (std::size_t i = 0; i < coordinates_.size() && largest_ > 0; ++i) {
            coordinates_[i] /= i % width_ < dimension_ ? largest_ : 1;
        }
        rungs_.resize(coordinates_.size());
    }

    double at(double u) {
        std::ranges::copy(coordinates_, rungs_.begin());
        for (auto left = rungs_.size(); left > width_; left -= width_) {
            for (std::size_t i = 0; i + width_ < left; ++i) {
                rungs_[i] = lerp(rungs_[i], rungs_[i + width_], u);
            }
        }
        double sum = 0;
        for (std::size_t c = 0; c < dimension_; ++c) {
            sum += rungs_[c] * rungs_[c];
        }
        return largest_ * std::sqrt(sum) / (width_ > dimension_ ? rungs_[dimension_] : 1);
    }

    /// Length from u = start to u = end, by one panel.
    double integral(double start, double end) {
        const double middle = 0.5 * (start + end);
        const double half = 0.5 * (end - start);
        double sum = 0;
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            sum += weights[i] * (at(middle - half * nodes[i]) + at(middle + half * nodes[i]));
        }
        return half * sum;
    }

    /// A size of the piece to compare errors with: its length if its speed were the mean of that of
    /// the hodograph's Bézier points.
    double bound() const {
        const Piece piece = hodograph_[0];
        double sum = 0;
        for (int i = 0; i <= piece.degree; ++i) {
            sum += norm(piece.bezierPoint(i));
        }
        return sum / (piece.degree + 1);
    }

  private:
    Pieces hodograph_;
    std::vector<double> coordinates_; // of the hodograph, divided by the largest
    std::vector<double> rungs_;
    std::size_t dimension_, width_;
    double largest_ = 0;
};

} // namespace

/// Cuts [start, end] of a piece into panels until each agrees with its halves.
class ArcLength::Survey {
  public:
    Survey(ArcLength& lengths, std::size_t segment, Speed& speed)
        : lengths_(lengths), segment_(segment), speed_(speed),
          tolerance_(converged * speed.bound()) {}

    void measure(double start, double end, double whole, int depth) {
        const double middle = 0.5 * (start + end);
        const double left = speed_.integral(start, middle);
        const double right = speed_.integral(middle, end);
        if (depth == deepest || !(std::abs(left + right - whole) > tolerance_)) {
            add(start, middle, left);
            add(middle, end, right);
            return;
        }
        measure(start, middle, left, depth + 1);
        measure(middle, end, right, depth + 1);
    }

  private:
    void add(double start, double end, double length) {
        const double before = lengths_.total();
        lengths_.panels_.push_back({segment_, start, end, before, before + length});
    }

    ArcLength& lengths_;
    std::size_t segment_;
    Speed& speed_;
    double tolerance_;
};

ArcLength::ArcLength(const Pieces& pieces) : pieces_(&pieces) {
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        Speed speed(pieces[i]);
        Survey(*this, i, speed).measure(0, 1, speed.integral(0, 1), 0);
    }
}

double ArcLength::upTo(Spot spot) const {
    const auto endsBefore = [](const Panel& panel, const Spot& s) {
        return panel.segment < s.segment || (panel.segment == s.segment && panel.end < s.u);
    };
    const auto panel = std::lower_bound(panels_.begin(), panels_.end(), spot, endsBefore);
    if (panel == panels_.end()) {
        return total();
    }
    return panel->lengthAtStart + Speed((*pieces_)[spot.segment]).integral(panel->start, spot.u);
}

Spot ArcLength::spotAt(double length) const {
    if (panels_.empty() || !(length > 0)) {
        return {};
    }
    if (length >= total()) {
        return {panels_.back().segment, panels_.back().end};
    }
    const auto panel = std::ranges::lower_bound(panels_, length, {}, &Panel::lengthAtEnd);
    // Newton's method on the length, kept between bounds that close in from both sides.
    Speed speed((*pieces_)[panel->segment]);
    const double wanted = length - panel->lengthAtStart;
    const double whole = panel->lengthAtEnd - panel->lengthAtStart;
    double low = panel->start;
    double high = panel->end;
    double u = lerp(low, high, whole > 0 ? wanted / whole : 1);
    for (int step = 0; step < 60; ++step) {
        const double excess = speed.integral(panel->start, u) - wanted;
        (excess > 0 ? high : low) = u;
        const double rate = speed.at(u);
        double next = rate > 0 ? u - excess / rate : low;
        if (!(next > low && next < high)) {
            next = 0.5 * (low + high);
        }
        if (std::abs(next - u) <= 1e-16 || next == u) {
            return {panel->segment, next};
        }
        u = next;
    }
    return {panel->segment, u};
}

} // namespace splineloft
