#include "core/spline/change/convert.h"

#include "core/spline/catalog.h"
#include "core/spline/change/proposers.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace splineloft {
namespace {

using namespace conversion;

/// How curves of one family are found.
struct Conversion {
    std::string_view family;
    void (*propose)(const Shape& shape, Trial& trial);
    int leastDegree; ///< lower ones are elevated to it
    int mostDegree;
    bool onePiece;
    std::string_view demand; ///< what the family asks of the curve
};

constexpr int bezierDegree = 255; // 256 points
constexpr int lagrangeDegree = 23;
constexpr int splineDegree = 25;

constexpr std::array conversions = {
    Conversion{"linear", proposeLinear, 1, 1, false, "segments are straight and of even speed"},
    Conversion{"lagrange", proposeLagrange, 1, lagrangeDegree, true, "it is one polynomial"},
    Conversion{"parametric-parabola", proposeParametricParabola, 2, 2, false,
               "parabola follows parabola without a gap"},
    Conversion{"bezier", proposeBezier, 1, bezierDegree, true, "it is one piece"},
    Conversion{"bezier-spline", proposeBezierSpline, 3, 3, false,
               "cubic follows cubic without a gap"},
    Conversion{"hermite", proposeHermite, 3, 3, false,
               "one tangent at each point serves the segments on both sides"},
    Conversion{"cardinal", proposeCardinal, 3, 3, false,
               "each tangent is a multiple of the chord between the neighbours"},
    Conversion{"catmull-rom", proposeCatmullRom, 3, 3, false,
               "each tangent is that of the parabola through the point and its neighbours"},
    Conversion{"kochanek-bartels", proposeKochanekBartels, 3, 3, false,
               "tangents are shared out between the chords by tension, continuity and bias"},
    Conversion{"natural", proposeNatural, 3, 3, false,
               "second derivatives are continuous, and vanish at free ends"},
    Conversion{"b-spline", proposeBSpline, 1, splineDegree, false,
               "a closed one has no gap, and derivatives are those of a polynomial"},
    Conversion{"bc-spline", proposeBcSpline, 3, 3, false,
               "each segment is the same symmetric blend of its four points"},
    Conversion{"duff", proposeDuff, 3, 3, false,
               "each segment is the same tensioned B-spline of its four points"},
    Conversion{"beta", proposeBeta, 3, 3, false,
               "bias and tension are the same at all joints, direction and curvature continuous"},
    Conversion{"nurbs", proposeBSpline, 1, splineDegree, false, "a closed one has no gap"},
};

bool isConnected(const Shape& shape) {
    const auto& pieces = shape.pieces;
    for (std::size_t i = 0; i < shape.joints(); ++i) {
        const auto before = (i + shape.size() - 1) % shape.size();
        const Point end = pieces[before].bezierPoint(pieces.degree());
        if (shape.isInner(i) && distance(end, shape.joint(i)) > shape.tolerance) {
            return false;
        }
    }
    return true;
}

/// A family, other than its own, that can be this curve.
std::string remedyFor(const Shape& shape, std::string_view own) {
    const auto& pieces = shape.pieces;
    const bool isRational = pieces.form() == Form::rational;
    const bool connected = isConnected(shape);
    const bool fits = pieces.degree() <= splineDegree && (connected || !shape.closed);
    const bool cubic = !isRational && (pieces.degree() <= 3 || lowered(pieces, 3, shape.tolerance));
    if (cubic && connected && own != "bezier-spline") {
        return "bezier-spline, which keeps every curve of degree 3";
    }
    if (!isRational && fits && own != "b-spline") {
        return "b-spline, which keeps every polynomial curve";
    }
    if (fits && own != "nurbs") {
        return "nurbs, which keeps every rational curve";
    }
    const bool single = shape.size() == 1 && !shape.closed && pieces.degree() <= bezierDegree;
    return single && !isRational && own != "bezier" ? "bezier, which keeps every polynomial piece"
                                                    : "the family that it has";
}

/// The shape in a degree that the family has: its own as far as possible.
std::optional<Shape> suited(const Shape& shape, const Conversion& target) {
    Shape result = shape;
    const int own = shape.pieces.degree();
    const bool isRational = shape.pieces.form() == Form::rational;
    if (own > 3 && target.mostDegree > 3 && !isRational) {
        for (int degree = 3; degree < std::min(own, target.mostDegree + 1); ++degree) {
            if (auto low = lowered(shape.pieces, degree, shape.tolerance)) {
                result.pieces = std::move(*low);
                return result;
            }
        }
    }
    const int degree = std::clamp(own, target.leastDegree, target.mostDegree);
    auto pieces =
        isRational && own > degree ? std::nullopt : ofDegree(shape.pieces, degree, shape.tolerance);
    if (!pieces) {
        return std::nullopt;
    }
    result.pieces = std::move(*pieces);
    return result;
}

/// What keeps the shape from being of the family, as far as that is seen without trying.
std::optional<std::string> obstacle(const Shape& shape, const Conversion& target,
                                    const Family& family) {
    const std::string name(family.id);
    if (shape.closed && !family.closable) {
        return "a closed curve cannot be of the family " + name;
    }
    if (shape.pieces.form() == Form::rational && !family.usesWeights) {
        return "the curve is rational, its weights differ within a segment, and the family " +
               name + " has none";
    }
    if (target.onePiece && shape.size() != 1) {
        return "the curve has " + std::to_string(shape.size()) + " pieces, one of the family " +
               name + " has 1";
    }
    return std::nullopt;
}

/// The points in the size that they had.
Points resized(const Points& table, int exponent) {
    Points result(table.dimension());
    result.reserve(table.size());
    for (std::size_t i = 0; i < table.size(); ++i) {
        Point place = table.at(i);
        for (int c = 0; c < place.dimension(); ++c) {
            place[c] = std::scalbn(place[c], exponent);
        }
        result.append(place);
    }
    return result;
}

std::variant<Curve, Problem> searched(const Curve& curve, const Shape& shape,
                                      const Conversion& target, const Family& family) {
    const auto refused = [&](std::string what) {
        return Problem{"/family", std::move(what), remedyFor(shape, curve.family)};
    };
    if (const auto reason = obstacle(shape, target, family)) {
        return refused(*reason);
    }
    const auto suitable = suited(shape, target);
    if (!suitable) {
        return refused("a curve of degree " + std::to_string(shape.pieces.degree()) +
                       " cannot be of the family " + std::string(family.id) +
                       ", which has degree " + std::to_string(target.mostDegree) + " at most");
    }
    Trial trial(shape, curve, family.id);
    target.propose(*suitable, trial);
    if (!trial.found()) {
        return refused("of the family " + std::string(family.id) + " there is no such curve: " +
                       trial.whyNot() + " (" + std::string(target.demand) + ")");
    }
    Curve result = *trial.found();
    result.points = resized(result.points, shape.exponent);
    result.tangents = resized(result.tangents, shape.exponent);
    if (const auto problem = problemOf(result)) { // beyond the largest number
        return refused("its " + problem->place + " " + problem->what);
    }
    return result;
}

} // namespace

std::variant<Curve, Problem> converted(const Curve& curve, std::string_view family) {
    if (auto problem = problemOf(curve)) {
        return *problem;
    }
    if (curve.family == family) {
        return curve;
    }
    const auto target = std::ranges::find(conversions, family, &Conversion::family);
    const Family* described = findFamily(family);
    if (target == conversions.end() || described == nullptr) {
        return Problem{"/family", "there is no conversion to \"" + std::string(family) + "\"",
                       "an id from the catalog of families, such as bezier-spline"};
    }
    const Pieces pieces = piecesOf(curve);
    if (pieces.empty()) {
        return Problem{"/points", "has too few points for a piece",
                       std::to_string(fewestPoints(curve)) + " points or more"};
    }
    if (!std::ranges::all_of(pieces.bezier(), [](double x) { return std::isfinite(x); })) {
        return Problem{"/points", "are too far apart: the curve leaves the range of numbers",
                       "points nearer to the origin"};
    }
    return searched(curve, shapeOf(pieces, curve.closed), *target, *described);
}

} // namespace splineloft
