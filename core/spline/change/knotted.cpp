#include "core/spline/change/knotted.h"

#include "core/spline/change/shape.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace splineloft::conversion {
namespace {

constexpr auto noPiece = std::numeric_limits<std::size_t>::max();

// The range of weights that a curve may have (problem.cpp).
constexpr double mostWeight = 1e9;

/// All knots, and which piece lies between each and the next.
struct Line {
    std::vector<double> knots;
    std::vector<std::size_t> pieceAt;
};

/// The blossom of a piece over [start, start + interval]: its ladder, each level at an argument of
/// its own. Homogeneous.
Point blossomOf(const Piece& piece, std::span<const double> arguments, double start,
                double interval) {
    std::vector<Point> rungs;
    for (int k = 0; k <= piece.degree; ++k) {
        rungs.push_back(homogeneous(piece, k));
    }
    for (std::size_t level = 0; level < arguments.size(); ++level) {
        climb(std::span(rungs).first(rungs.size() - level), (arguments[level] - start) / interval);
    }
    return rungs.front();
}

/// Control point `index` of the line, from the piece nearest to the middle of its knots, where its
/// blossom reaches out least.
Point controlPoint(const Pieces& pieces, const Line& line, std::size_t index) {
    const auto degree = static_cast<std::size_t>(pieces.degree());
    const auto& knots = line.knots;
    const auto own = std::span(knots).subspan(index + 1, degree);
    const double middle = lerp(own.front(), own.back(), 0.5);
    std::size_t best = noPiece;
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t k = index; k <= index + degree; ++k) {
        const double away = std::abs(lerp(knots[k], knots[k + 1], 0.5) - middle);
        if (line.pieceAt[k] != noPiece && (best == noPiece || away < nearest)) {
            best = k;
            nearest = away;
        }
    }
    return blossomOf(pieces[line.pieceAt[best]], own, knots[best], knots[best + 1] - knots[best]);
}

/// Gives the curve `count` control points, beginning with number `first` of the line.
std::optional<Curve> withControls(const Pieces& pieces, const Line& line, std::size_t first,
                                  std::size_t count, Curve curve) {
    const int dimension = pieces.dimension();
    for (std::size_t i = first; i < first + count; ++i) {
        const Point point = controlPoint(pieces, line, i);
        if (pieces.form() == Form::polynomial) {
            curve.points.append(point);
            continue;
        }
        const double weight = point[dimension];
        if (!(weight > 0)) {
            return std::nullopt;
        }
        const Point place(point.coordinates().first(static_cast<std::size_t>(dimension)));
        curve.points.append((1 / weight) * place);
        curve.weights.push_back(weight);
    }
    // Only ratios matter, so a range that is too high can come down.
    const double most = curve.weights.empty() ? 1 : std::ranges::max(curve.weights);
    for (double& weight : curve.weights) {
        weight = most > mostWeight || most < 1 / mostWeight ? weight / most : weight;
    }
    return curve;
}

/// Numbers the pieces between those of `knots` that differ.
std::vector<std::size_t> piecesBetween(std::span<const double> knots) {
    std::vector<std::size_t> pieceAt;
    std::size_t piece = 0;
    for (std::size_t k = 0; k + 1 < knots.size(); ++k) {
        pieceAt.push_back(knots[k] < knots[k + 1] ? piece++ : noPiece);
    }
    return pieceAt;
}

std::vector<double> written(const JointKnots& knots, std::size_t from, std::size_t to) {
    std::vector<double> all;
    for (std::size_t i = from; i < to; ++i) {
        all.insert(all.end(), static_cast<std::size_t>(knots.times[i]), knots.at[i]);
    }
    return all;
}

/// The knots of a closed curve, continued around the loop by `degree` on either side.
Line aroundTheLoop(const std::vector<double>& own, std::size_t degree) {
    const auto n = own.size() - 1;
    const double period = own.back() - own.front();
    const auto pieceAt = piecesBetween(own);
    Line line;
    const auto turnsBefore = (degree + n - 1) / n;
    for (std::size_t i = 0; i <= n + 2 * degree; ++i) {
        const auto at = i + turnsBefore * n - degree;
        const double turns = static_cast<double>(at / n) - static_cast<double>(turnsBefore);
        line.knots.push_back(own[at % n] + turns * period);
        line.pieceAt.push_back(pieceAt[at % n]);
    }
    line.knots[degree + n] = own.back();
    return line;
}

std::optional<Curve> closedKnotted(const Pieces& pieces, const std::vector<double>& own,
                                   Curve curve) {
    const auto degree = static_cast<std::size_t>(pieces.degree());
    const std::size_t lead = (degree - 1) / 2; // as the families' layout has it
    return withControls(pieces, aroundTheLoop(own, degree), lead, own.size() - 1, std::move(curve));
}

/// Whether derivative number `order` by t is continuous from one piece to the next. Both are
/// measured as differences of Bézier points over the shorter interval.
bool agrees(const Pieces& pieces, std::size_t before, std::size_t after, int order,
            double tolerance) {
    const double left = pieces.knots().interval(before);
    const double right = pieces.knots().interval(after);
    const double shorter = std::min(left, right);
    const int degree = pieces.degree();
    const auto difference = [&](const Piece& piece, int from, double interval) {
        std::vector<Point> rungs;
        for (int k = 0; k <= order; ++k) {
            rungs.push_back(homogeneous(piece, from + k));
        }
        for (auto left_ = rungs.size(); left_ > 1; --left_) {
            for (std::size_t k = 0; k + 1 < left_; ++k) {
                rungs[k] = rungs[k + 1] - rungs[k];
            }
        }
        return std::pow(shorter / interval, order) * rungs.front();
    };
    const Point jump =
        difference(pieces[after], 0, right) - difference(pieces[before], degree - order, left);
    return norm(jump) <= std::exp2(order) * tolerance;
}

int timesNeeded(const Pieces& pieces, std::size_t before, std::size_t after, double tolerance) {
    int order = 0;
    while (order < pieces.degree() && agrees(pieces, before, after, order, tolerance)) {
        ++order;
    }
    return std::max(1, pieces.degree() - order + 1);
}

std::vector<double> jointsOf(const Pieces& pieces) {
    const auto knots = pieces.knots().knots();
    return {knots.begin(), knots.end()};
}

} // namespace

std::size_t timesOf(const Curve& curve, double knot) {
    if (!curve.closed) {
        return static_cast<std::size_t>(std::ranges::count(curve.knots, knot));
    }
    // The last is the first again: either stands for the seam.
    const auto own = std::span(curve.knots).first(curve.knots.size() - 1);
    const bool seam = knot == curve.knots.front() || knot == curve.knots.back();
    const auto times = seam ? std::ranges::count(own, curve.knots.front()) +
                                  std::ranges::count(own, curve.knots.back())
                            : std::ranges::count(own, knot);
    return static_cast<std::size_t>(times);
}

JointKnots knotsNeeded(const Pieces& pieces, bool closed, double tolerance) {
    const auto count = pieces.size();
    JointKnots knots{jointsOf(pieces), std::vector<int>(count + 1, pieces.degree() + 1)};
    for (std::size_t i = closed ? 0 : 1; i < count; ++i) {
        const int times = timesNeeded(pieces, (i + count - 1) % count, i, tolerance);
        knots.times[i] = closed ? std::min(times, pieces.degree()) : times;
    }
    return knots;
}

JointKnots knotsOfBezierPoints(const Pieces& pieces, bool closed) {
    JointKnots knots{jointsOf(pieces), std::vector<int>(pieces.size() + 1, pieces.degree())};
    if (!closed) {
        ++knots.times.front();
        ++knots.times.back();
    }
    return knots;
}

std::optional<Curve> knotted(const Pieces& pieces, const JointKnots& knots, Curve blank) {
    const auto pieceCount = pieces.size();
    blank.ends = Ends::none;
    if (blank.closed) {
        blank.knots = written(knots, 0, pieceCount);
        blank.knots.push_back(knots.at.back());
        return closedKnotted(pieces, blank.knots, blank);
    }
    const auto degree = static_cast<std::size_t>(pieces.degree());
    blank.knots = written(knots, 0, pieceCount + 1);
    const auto count = blank.knots.size() - degree - 1;
    return withControls(pieces, {blank.knots, piecesBetween(blank.knots)}, 0, count, blank);
}

std::optional<Curve> uniformlyKnotted(const Pieces& pieces, Curve blank) {
    const auto degree = static_cast<std::size_t>(pieces.degree());
    const auto count = pieces.size();
    std::vector<double> whole;
    for (std::size_t i = 0; i <= count + (blank.closed ? 0 : 2 * degree); ++i) {
        whole.push_back(static_cast<double>(i));
    }
    if (blank.closed) {
        return closedKnotted(pieces, whole, std::move(blank));
    }
    Line line{whole, std::vector<std::size_t>(whole.size() - 1, noPiece)};
    for (std::size_t i = 0; i < count; ++i) {
        line.pieceAt[degree + i] = i;
    }
    return withControls(pieces, line, 0, count + degree, std::move(blank));
}

} // namespace splineloft::conversion
