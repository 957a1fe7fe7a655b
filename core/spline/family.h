// A spline family: a way of blending control points into Bézier points.
//
// A family is one file: a small struct with a function template that fills in the Bézier points,
// written once for coordinates and for blends, and a description of itself. The catalog lists them.
#pragma once

#include "core/spline/blend.h"
#include "core/spline/piece.h"
#include "core/spline/ranges.h"

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

namespace splineloft {

/// How an open curve begins and stops.
enum class Ends {
    none,      ///< the family needs no help
    open,      ///< the first and last points are used for starting and stopping only
    doubled,   ///< the first and last points count twice
    reflected, ///< 2 P0 - P1 is put before P0, likewise at the end
    clamped    ///< the first and last knots of the B-spline have full multiplicity
};

/// How a parameter's slider moves.
enum class Scale {
    linear,
    ratio, ///< logarithmic: 2 lies as far above 1 as 1/2 lies below
    whole  ///< whole numbers only
};

/// A number that shapes every curve of a family.
struct Parameter {
    std::string_view key;   ///< as in files, e.g. "tension"
    std::string_view label; ///< for people
    std::string_view symbol;
    double least, most;             ///< accepted values, both included
    double sliderLeast, sliderMost; ///< the range worth sliding through
    double neutral;                 ///< value without effect, or the usual one; also the default
    Scale scale;
    std::string_view meaning; ///< which way it pulls, and what the neutral value is
    bool local = false;       ///< may have a value of its own at each control point
};

/// How pieces read the control points: piece i reads `window` points in a row, beginning `stride`
/// points after those of piece i - 1. The first `lead` of them lie before the piece's own first
/// joint, which matters where a closed curve starts.
struct Layout {
    int degree = 1; ///< of every piece
    int window = 2;
    int stride = 1;
    int lead = 0;
    Form form = Form::polynomial;
};

/// What a layout depends on.
struct Extent {
    std::span<const double> parameters; ///< in the order of the family's description
    std::size_t points = 0;
    bool local = false; ///< a parameter has a value of its own at each control point
};

/// What a family is given to blend. The ends have been arranged already: `points` includes the
/// points added at the ends or around a closed curve.
template <Blendable T> struct Input {
    std::span<const T> points;
    std::span<const T> tangents; ///< one a point, for families that use them; by unit interval
    /// Parameter values. One a point; for B-splines the knots, points + degree + 1 of them.
    std::span<const double> knots;
    /// Where chords space the knots, the intervals between them: to be read rather than their
    /// differences, which round otherwise when a point before them moves.
    std::span<const double> intervals;
    std::span<const double> parameters; ///< in the order of the family's description
    /// For each parameter its values at the points, or none where it has the same everywhere.
    std::span<const std::vector<double>> local;
    /// Where the window of each piece begins among the points.
    std::span<const std::size_t> windows;
    Layout layout;
    bool closed = false; ///< the first point stands again at the end of `points`

    /// The value of a parameter at a point.
    double parameterAt(std::size_t parameter, std::size_t point) const {
        return local.empty() || local[parameter].empty() ? parameters[parameter]
                                                         : local[parameter][point];
    }
};

/// Fills `bezier` with the (degree + 1) Bézier points of each piece of a range; in rational form
/// each of them times its weight, which is what the same blending makes of points that are all 1.
template <Blendable T>
using Blending = void (*)(const Input<T>& input, Range range, std::span<T> bezier);

/// Where the parameter values come from.
enum class Spacing {
    uniform,   ///< joints at whole numbers
    chord,     ///< chord length to the power of the parameter `alpha`
    knotVector ///< a B-spline's knots: given, or chord lengths to the power `alpha`
};

/// One entry of the catalog.
struct Family {
    std::string_view id;   ///< as in files
    std::string_view name; ///< for people
    std::string_view summary;
    std::string_view source = {}; ///< author and year; none where nobody is named
    std::vector<Parameter> parameters = {};
    std::vector<Ends> ends; ///< those it accepts, the usual one first; {none} where it needs none
    bool closable = true;
    bool usesTangents = false;
    bool usesKnots = false;   ///< may be given its knots
    bool usesWeights = false; ///< each control point has a weight
    bool hasHandles = false;  ///< of every three points the first is an anchor, the others handles
    std::size_t mostPoints = 1'000'000;
    bool isLocal = false;          ///< each piece depends on the points of its own window alone
    double mostCoordinate = 1e300; ///< up to which all derivatives by u are finite
    Spacing spacing = Spacing::uniform;

    Layout (*layout)(const Extent& extent) = nullptr;
    Blending<double> blendCoordinates = nullptr;
    Blending<Blend> blendRecipes = nullptr;
};

/// A family whose pieces each look only at their own window: `Rule::piece(input, first, bezier)` is
/// told where the window begins among the points and fills in one piece.
template <class Rule, Blendable T>
void blendLocally(const Input<T>& input, Range range, std::span<T> bezier) {
    const auto count = static_cast<std::size_t>(input.layout.degree) + 1;
    for (std::size_t i = range.first; i < range.last; ++i) {
        Rule::piece(input, input.windows[i], bezier.subspan((i - range.first) * count, count));
    }
}

/// Completes a description with the rule of a local family.
template <class Rule> Family localFamily(Family description) {
    description.blendCoordinates = &blendLocally<Rule, double>;
    description.blendRecipes = &blendLocally<Rule, Blend>;
    description.isLocal = true;
    return description;
}

/// Completes a description with the rule of a family that needs all points at once:
/// `Rule::pieces(input, range, bezier)`.
template <class Rule> Family globalFamily(Family description) {
    description.blendCoordinates = &Rule::template pieces<double>;
    description.blendRecipes = &Rule::template pieces<Blend>;
    return description;
}

/// Layout of a single piece that takes all points.
inline Layout onePiece(const Extent& extent) {
    const int n = extent.points < 2 ? 2 : static_cast<int>(extent.points);
    return {n - 1, n, n, 0};
}
/// Layout of the local cubics: the piece between the middle two of each four points.
inline Layout fourPointCubic(const Extent&) {
    return {3, 4, 1, 1};
}
/// Layout of cubics from point to point that need no other.
inline Layout twoPointCubic(const Extent&) {
    return {3, 2, 1, 0};
}

} // namespace splineloft
