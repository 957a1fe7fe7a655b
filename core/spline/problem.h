// What may be wrong with a curve, said before anything is computed from it.
#pragma once

#include "core/spline/curve.h"

#include <optional>
#include <string>
#include <string_view>
#include <variant>

namespace splineloft {

/// What is wrong with a value, where, and what would be right.
struct Problem {
    std::string place; ///< JSON pointer from the curve, e.g. "/points/3"
    std::string what;
    std::string remedy;
};

/// One token of a JSON pointer, with its slash: ~ and / escaped, shortened where it is very long.
std::string pointerToken(std::string_view key);
std::string pointerToken(std::size_t index);

/// The first thing that keeps a spline through these points from being drawn, if any. Too few
/// points are no fault: such a curve has no pieces yet.
std::optional<Problem> problemOf(const Spline& spline, const PointsView& points,
                                 const PointsView& tangents = {});

/// The first of the points or tangents that lies where it must not, if any.
std::optional<Problem> placesProblem(const Spline& spline, const PointsView& points,
                                     const PointsView& tangents = {});

/// The same as the first of a curve and the names of its coordinates.
std::optional<Problem> problemOf(const Curve& curve);

/// The curve where nothing is wrong with it, else the first thing that is.
std::variant<Curve, Problem> checked(Curve curve);

} // namespace splineloft
