#include "core/spline/shape/flatten.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace splineloft {
namespace {

/// Places in units of the curve's size, which neither overflow nor underflow when multiplied.
double unitOf(const Pieces& pieces) {
    double farthest = 0;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        for (int k = 0; k <= pieces.degree(); ++k) {
            const Point place = pieces[i].bezierPoint(k);
            for (const double x : place.coordinates()) {
                farthest = std::max(farthest, std::abs(x));
            }
        }
    }
    int exponent = 0;
    std::frexp(farthest, &exponent);
    return std::isfinite(farthest) ? std::ldexp(1, std::clamp(exponent, -1022, 1023)) : 1;
}

/// One piece, walked along in steps.
class PieceWalk {
  public:
    PieceWalk(const Piece& piece, double tolerance, double unit)
        : bezier_(piece.coordinates.begin(), piece.coordinates.end()),
          width_(static_cast<std::size_t>(piece.width())),
          dimension_(static_cast<std::size_t>(piece.dimension)), tolerance_(tolerance) {
        for (std::size_t i = 0; i < bezier_.size(); ++i) {
            const bool isWeight = i % width_ >= dimension_;
            bezier_[i] = isWeight ? bezier_[i] : bezier_[i] * (1 / unit);
        }
    }

    /// The parameter values at which the steps after the first spot end; fewer than reach 1 if
    /// there are more than `most`, or if rounding makes the tolerance unreachable.
    std::vector<double> steps(std::size_t most) {
        std::vector<double> ends;
        double from = 0;
        double step = 1;
        while (from < 1 && ends.size() < most) {
            const double to = reach(from, step);
            if (!(to > from)) {
                break;
            }
            step = to - from;
            from = to;
            ends.push_back(to);
        }
        return ends;
    }

  private:
    double* point(std::size_t index) { return stretch_.data() + index * width_; }
    std::size_t degree() const { return bezier_.size() / width_ - 1; }

    /// Puts the Bézier points from one u to another into `stretch_`: `stretchOf` in place.
    void cut(double from, double to) {
        stretch_ = bezier_;
        for (std::size_t level = 1; level <= degree() && to < 1; ++level) {
            for (std::size_t i = stretch_.size(); i-- > level * width_;) {
                stretch_[i] = lerp(stretch_[i - width_], stretch_[i], to);
            }
        }
        for (std::size_t level = 1; level <= degree() && from > 0; ++level) {
            for (std::size_t i = 0; i + level * width_ < stretch_.size(); ++i) {
                stretch_[i] = lerp(stretch_[i], stretch_[i + width_], from / to);
            }
        }
    }

    /// The most that the inner Bézier points of the stretch together can count: the curve is no
    /// farther from its chord than that times the farthest of them, because distance from a chord
    /// is convex and the first and the last point have none (Jensen's inequality).
    double innerShare() {
        const double inner = std::max(1 - std::ldexp(1, 1 - static_cast<int>(degree())), 0.0);
        if (width_ == dimension_ || degree() < 2) {
            return inner;
        }
        const double ends = std::min(point(0)[dimension_], point(degree())[dimension_]);
        double largest = 0;
        for (std::size_t k = 1; k < degree(); ++k) {
            largest = std::max(largest, point(k)[dimension_]);
        }
        return largest * inner / (largest * inner + ends * (1 - inner));
    }

    /// How far Bézier point k of the stretch is from its chord, all points as ways from the first.
    double distanceFromChord(std::size_t k, double squared) {
        const double* end = point(degree());
        const double* way = point(k);
        double along = 0;
        for (std::size_t c = 0; c < dimension_; ++c) {
            along += way[c] * end[c];
        }
        along = squared > 0 ? std::clamp(along / squared, 0.0, 1.0) : 0;
        double sum = 0;
        for (std::size_t c = 0; c < dimension_; ++c) {
            const double off = way[c] - along * end[c];
            sum += off * off;
        }
        return std::sqrt(sum);
    }

    /// A bound of the distance between the curve and the chord from one u to another.
    double distanceBetween(double from, double to) {
        cut(from, to);
        const double share = innerShare();
        for (std::size_t k = degree() + 1; k-- > 0;) {
            for (std::size_t c = 0; c < dimension_; ++c) {
                const bool rational = width_ > dimension_;
                const double first = rational ? point(0)[c] / point(0)[dimension_] : point(0)[c];
                point(k)[c] = (rational ? point(k)[c] / point(k)[dimension_] : point(k)[c]) - first;
            }
        }
        double squared = 0, farthest = 0;
        for (std::size_t c = 0; c < dimension_; ++c) {
            squared += point(degree())[c] * point(degree())[c];
        }
        for (std::size_t k = 1; k < degree(); ++k) {
            farthest = std::max(farthest, distanceFromChord(k, squared));
        }
        return share * farthest;
    }

    /// How far a step can go: nearly as far as the tolerance lets it. `guess` is the step before.
    double reach(double from, double guess) {
        constexpr double enough = 0.95; // of the tolerance: nearer would not save a spot in forty
        constexpr int mostTries = 80;   // halvings from 1 to the smallest step that a double has
        double best = from;
        double step = std::min(guess, 1 - from);
        for (int tries = 0, refinements = 0; tries < mostTries; ++tries) {
            const double to = from + step >= 1 ? 1 : from + step;
            if (!(to > from)) {
                break;
            }
            const double off = distanceBetween(from, to);
            const bool fits = off <= tolerance_;
            best = fits ? std::max(best, to) : best;
            if (fits && (to == 1 || off >= enough * tolerance_)) {
                break;
            }
            // Distance grows with the square of the step.
            const double ratio = std::sqrt(0.98 * tolerance_ / off);
            const double factor = std::isfinite(ratio) ? std::clamp(ratio, 0.125, 4.0) : 4.0;
            step = std::min(step * factor, 1 - from);
            if (best > from && (++refinements == 4 || from + step <= best)) {
                break;
            }
        }
        return best;
    }

    std::vector<double> bezier_; // in the unit
    std::vector<double> stretch_;
    std::size_t width_, dimension_;
    double tolerance_;
};

/// At most `most` spots, as many on each piece; where there are more pieces, joints only.
std::vector<Spot> spreadEvenly(const Pieces& pieces, std::size_t most) {
    const std::size_t each = (most - 1) / pieces.size();
    std::vector<Spot> spots;
    for (std::size_t i = 0; each > 0 && i < pieces.size(); ++i) {
        for (std::size_t k = 0; k < each; ++k) {
            spots.push_back({i, static_cast<double>(k) / static_cast<double>(each)});
        }
    }
    for (std::size_t k = 0; each == 0 && k + 1 < most; ++k) {
        spots.push_back({k * pieces.size() / (most - 1), 0});
    }
    spots.push_back({pieces.size() - 1, 1});
    return spots;
}

/// Whether piece `segment` begins where the one before it ends. (A B-spline can be torn apart by
/// knots of full multiplicity.)
bool joins(const Pieces& pieces, std::size_t segment, double unit) {
    const Point end = pieces[segment - 1].bezierPoint(pieces.degree());
    const Point start = pieces[segment].bezierPoint(0);
    return norm((1 / unit) * end - (1 / unit) * start) <=
           64 * std::numeric_limits<double>::epsilon();
}

} // namespace

Polyline flattened(const Pieces& pieces, double tolerance, std::size_t most) {
    if (pieces.empty()) {
        return {{}, true};
    }
    most = std::max<std::size_t>(most, 2);
    const double unit = unitOf(pieces);
    const double asked = tolerance > 0 ? tolerance / unit : 0;
    Polyline line{{{0, 0}}, true};
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        if (i > 0) {
            if (!joins(pieces, i, unit)) {
                line.spots.push_back({i - 1, 1});
            }
            line.spots.push_back({i, 0});
        }
        const std::size_t room = most - std::min(most, line.spots.size());
        const auto steps = PieceWalk(pieces[i], asked, unit).steps(room);
        if (steps.empty() || steps.back() < 1) {
            return {spreadEvenly(pieces, most), false};
        }
        for (const double u : steps) {
            if (u < 1) {
                line.spots.push_back({i, u});
            }
        }
    }
    line.spots.push_back({pieces.size() - 1, 1});
    return line;
}

} // namespace splineloft
