// A curve as a person describes it: control points, a family, and how it ends. A plain value. What
// it looks like is worked out from it by `piecesOf` and `blendsOf`.
#pragma once

#include "core/spline/family.h"
#include "core/spline/piece.h"
#include "core/spline/point.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace splineloft {

/// The description of one curve.
struct Curve {
    std::string name = "curve";
    std::string family = "cardinal";
    /// Values of the family's parameters by key; those left out have their neutral value.
    std::map<std::string, double> parameters;
    std::vector<std::string> coordinates = {"x", "y"}; ///< their names
    Points points;
    Points tangents; ///< one a control point in families that use them, otherwise empty
    bool closed = false;
    Ends ends = Ends::doubled;

    bool operator==(const Curve&) const = default;
};

/// What is wrong with a value, where, and what would be right.
struct Problem {
    std::string place; ///< JSON pointer from the curve, e.g. "/points/3"
    std::string what;
    std::string remedy;
};

/// The first thing that keeps a curve from being drawn, if any. Too few points are no fault: such a
/// curve has no pieces yet.
std::optional<Problem> problemOf(const Curve& curve);

/// The family of a curve. Throws std::invalid_argument where there is none of that id.
const Family& familyOf(const Curve& curve);

/// Values of all parameters in the order of the family's description.
std::vector<double> parametersOf(const Curve& curve);

/// Writes the neutral value of every parameter that was left out into `curve.parameters`.
void completeParameters(Curve& curve);

/// How the curve's pieces read its control points.
Layout layoutOf(const Curve& curve);

/// The fewest control points from which the curve has a piece.
std::size_t fewestPoints(const Curve& curve);

/// The curve as Bézier pieces: an open cubic has n - 3 of them with its ends open, n - 1 with its
/// ends doubled or reflected, a closed curve n. O(n). Throws std::invalid_argument with the words
/// of `problemOf` where there is a problem.
Pieces piecesOf(const Curve& curve);

/// The same pieces as blends of the controls. O(n) for local families, O(n^2) for natural ones.
BlendPieces blendsOf(const Curve& curve);

/// Which control point stands at or before the beginning of piece `segment`; for families that
/// approximate, the one nearest to it.
std::size_t controlAtStart(const Curve& curve, std::size_t segment);

/// The parameter value that belongs to each control point: for curves that pass through it, where
/// they do; for B-splines its Greville abscissa (the mean of the knots that it pulls between).
std::vector<double> abscissae(const Curve& curve);

} // namespace splineloft
