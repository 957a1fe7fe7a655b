#include "core/spline/convert.h"

#include "core/spline/catalog.h"

#include <cmath>

namespace splineloft {
namespace {

// Derivatives that differ by less than this part of their size differ by rounding only.
constexpr double agreement = 1e-12;

Problem noSuchCurve(std::string what, std::string remedy) {
    return {"/family", std::move(what), std::move(remedy)};
}

/// The curve's name, coordinates and closing, of another family and without points.
Curve emptied(const Curve& curve, std::string_view family) {
    Curve result;
    result.name = curve.name;
    result.family = family;
    result.coordinates = curve.coordinates;
    result.closed = curve.closed;
    result.ends = Ends::none;
    result.points = Points(curve.points.dimension());
    result.tangents = result.points;
    completeParameters(result);
    return result;
}

/// Whether a piece has weights that differ, so that no polynomial draws it.
bool isRational(const Pieces& pieces) {
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const double first = pieces[i].weight(0);
        for (int k = 1; k <= pieces.degree(); ++k) {
            if (std::abs(pieces[i].weight(k) - first) > agreement * first) {
                return true;
            }
        }
    }
    return false;
}

std::variant<Curve, Problem> toBezierSpline(const Curve& curve, const Pieces& pieces) {
    if (pieces.degree() > 3) {
        return noSuchCurve("a curve of degree " + std::to_string(pieces.degree()) +
                               " has no cubic pieces",
                           "a curve of degree 3 at most");
    }
    Curve result = emptied(curve, "bezier-spline");
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const auto bezier = elevated(pieces[i], 3);
        for (int k = 0; k < 3; ++k) {
            result.points.append(bezier[static_cast<std::size_t>(k)]);
        }
        if (i + 1 == pieces.size() && !curve.closed) {
            result.points.append(bezier[3]);
        }
    }
    return result;
}

std::variant<Curve, Problem> toHermite(const Curve& curve, const Pieces& pieces) {
    if (pieces.degree() > 3) {
        return toBezierSpline(curve, pieces); // which says why not
    }
    Curve result = emptied(curve, "hermite");
    const auto count = pieces.size();
    for (std::size_t i = 0; i < count + (curve.closed ? 0 : 1); ++i) {
        const bool last = i == count;
        const Jet jet = last ? pieces.jet({count - 1, 1}) : pieces.jet({i, 0});
        const bool inner = !last && (i > 0 || curve.closed);
        if (inner) {
            const Jet before = pieces.jet({(i + count - 1) % count, 1});
            if (distance(before.first, jet.first) > agreement * norm(before.first)) {
                return noSuchCurve("where segment " + std::to_string(i) +
                                       " begins the derivative by u jumps, and a Hermite curve has "
                                       "one tangent at each point",
                                   "bezier-spline, which keeps every curve of degree 3");
            }
        }
        result.points.append(jet.position);
        result.tangents.append(jet.first);
    }
    return result;
}

std::variant<Curve, Problem> toOnePiece(const Curve& curve, const Pieces& pieces) {
    if (pieces.size() != 1 || curve.closed) {
        return noSuchCurve("the curve has " + std::to_string(pieces.size()) + " pieces",
                           "a curve of one piece, or bezier-spline");
    }
    Curve result = emptied(curve, "bezier");
    for (int k = 0; k <= pieces.degree(); ++k) {
        result.points.append(pieces[0].bezierPoint(k));
    }
    return result;
}

std::variant<Curve, Problem> toLinear(const Curve& curve, const Pieces& pieces) {
    if (pieces.degree() != 1) {
        return noSuchCurve("a curve of degree " + std::to_string(pieces.degree()) +
                               " is not made of straight lines",
                           "a curve of degree 1");
    }
    Curve result = emptied(curve, "linear");
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        result.points.append(pieces[i].bezierPoint(0));
    }
    if (!curve.closed) {
        result.points.append(pieces[pieces.size() - 1].bezierPoint(1));
    }
    return result;
}

} // namespace

std::vector<Point> elevated(const Piece& piece, int degree) {
    std::vector<Point> points;
    for (int k = 0; k <= piece.degree; ++k) {
        points.push_back(piece.bezierPoint(k));
    }
    for (int d = piece.degree; d < degree; ++d) {
        std::vector<Point> next = {points.front()};
        for (int k = 1; k <= d; ++k) {
            const double share = static_cast<double>(k) / (d + 1);
            const auto at = static_cast<std::size_t>(k);
            next.push_back(share * points[at - 1] + (1 - share) * points[at]);
        }
        next.push_back(points.back());
        points = std::move(next);
    }
    return points;
}

std::variant<Curve, Problem> converted(const Curve& curve, std::string_view family) {
    if (curve.family == family) {
        return curve;
    }
    const Pieces pieces = piecesOf(curve);
    if (pieces.empty()) {
        return Problem{"/points", "has too few points for a piece",
                       std::to_string(fewestPoints(curve)) + " points or more"};
    }
    if (isRational(pieces)) {
        return noSuchCurve("the curve is rational, and no polynomial draws it exactly",
                           "a curve whose weights, or local parameters, are all the same");
    }
    if (family == "bezier-spline") {
        return toBezierSpline(curve, pieces);
    }
    if (family == "hermite") {
        return toHermite(curve, pieces);
    }
    if (family == "bezier") {
        return toOnePiece(curve, pieces);
    }
    if (family == "linear") {
        return toLinear(curve, pieces);
    }
    return noSuchCurve("there is no conversion to \"" + std::string(family) + "\"",
                       "bezier-spline, hermite, bezier or linear");
}

} // namespace splineloft
