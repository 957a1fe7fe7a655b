// A document: a few curves, as a plain value. Copies share the curves that they have in common, so
// that a snapshot costs a few pointers.
#pragma once

#include "core/spline/problem.h"

#include <compare>
#include <memory>
#include <string>
#include <vector>

namespace splineloft {

/// Limits of a document; beyond them it is refused by name.
inline constexpr std::size_t mostPointsOfACurve = 1'000'000;
inline constexpr double largestCoordinate = 1e9;

/// Curves in the order in which they are drawn.
struct Document {
    std::vector<std::shared_ptr<const Curve>> curves;
    /// What other programs keep in the file: JSON text of one object, carried along untouched.
    std::string extras = "{}";

    /// Equal where every curve is equal, shared or not.
    bool operator==(const Document& other) const;
};

/// What of a curve a `PointId` means.
enum class Part { point, tangent };

/// One control point, or the tangent at it, in a document.
struct PointId {
    std::size_t curve = 0;
    std::size_t index = 0;
    Part part = Part::point;
    auto operator<=>(const PointId&) const = default;
};

/// What is wrong with one of the document's curves, if anything: `place` begins with /curves/i.
std::optional<Problem> problemOf(const Document& document);

} // namespace splineloft
