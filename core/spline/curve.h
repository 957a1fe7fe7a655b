// A curve as a person describes it: control points, a family, its parameters, and how it ends. What
// it looks like is worked out from it by `piecesOf` and `blendsOf`.
#pragma once

#include "core/spline/family.h"
#include "core/spline/piece.h"
#include "core/spline/points_view.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace splineloft {

/// How control points are blended: all that a curve is but for its points.
struct Spline {
    std::string family = "cardinal";
    /// Values of the family's parameters by key; those left out have their neutral value.
    std::map<std::string, double> parameters = {};
    bool closed = false;
    Ends ends = Ends::doubled; ///< `none` for a B-spline with knots of its own
    /// A B-spline's own knots, which never fall: points + degree + 1 of them, the same up to
    /// degree + 1 times; of a closed one points + 1, the same up to degree times. None: from alpha.
    std::vector<double> knots = {};
    /// One a control point, above zero, in families that use them; none where all are 1.
    std::vector<double> weights = {};
    /// Values of a parameter at each control point, in place of the one for the whole curve.
    std::map<std::string, std::vector<double>> local = {};

    bool operator==(const Spline&) const = default;
};

/// The description of one curve: a spline, and the points that it blends.
struct Curve : Spline {
    std::string name = "curve";
    std::vector<std::string> coordinates = {"x", "y"}; ///< their names
    Points points;
    Points tangents; ///< one a control point in families that use them, otherwise empty

    bool operator==(const Curve&) const = default;
};

/// Whether two curves differ at most in where their points and tangents are.
bool differInPlacesAlone(const Curve& a, const Curve& b);

/// The family of a spline. Throws std::invalid_argument where there is none of that id.
const Family& familyOf(const Spline& spline);

/// Values of all parameters in the order of the family's description.
std::vector<double> parametersOf(const Spline& spline);

/// The value of one parameter; throws std::invalid_argument where the family has none of that key.
double parameterOf(const Spline& spline, std::string_view key);

/// Writes the neutral value of every parameter that was left out into `spline.parameters`.
void completeParameters(Spline& spline);

/// Whether the knots depend on where the points are, by chord lengths.
bool knotsFollowPoints(const Spline& spline);

/// How the pieces read so many control points.
Layout layoutOf(const Spline& spline, std::size_t points);
inline Layout layoutOf(const Curve& curve) {
    return layoutOf(curve, curve.points.size());
}

/// The fewest control points from which the spline has a piece.
std::size_t fewestPoints(const Spline& spline);

/// The curve as Bézier pieces: an open cubic has n - 3 of them with its ends open, n - 1 with its
/// ends doubled or reflected, a closed curve n. The points are read where they are. `tangents`, one
/// a point, are for families that use them. O(n). Throws std::invalid_argument with the words of
/// `problemOf` where there is a problem.
Pieces piecesOf(const Spline& spline, const PointsView& points, const PointsView& tangents = {});
Pieces piecesOf(const Curve& curve);

/// The same pieces as blends of the controls. O(n) for local families, O(n^2) for natural ones.
BlendPieces blendsOf(const Spline& spline, const PointsView& points,
                     const PointsView& tangents = {});
BlendPieces blendsOf(const Curve& curve);

/// The one piece of them, over its own two knots: O(n), in memory too.
BlendPieces blendsOfPiece(const Curve& curve, std::size_t segment);

/// Which control point stands at or before the beginning of piece `segment`; for families that
/// approximate, the one nearest to it.
std::size_t controlAtStart(const Curve& curve, std::size_t segment);

/// The parameter value that belongs to each control point: for curves that pass through it, where
/// they do; for B-splines its Greville abscissa (the mean of the knots that it pulls between).
std::vector<double> abscissae(const Curve& curve);

} // namespace splineloft
