// A document: a few curves, as a plain value. Copies share the curves that they have in common, so
// that a snapshot costs a few pointers.
#pragma once

#include "core/spline/problem.h"

#include <compare>
#include <concepts>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace splineloft {

/// Limits of a document; beyond them it is refused by name.
inline constexpr std::size_t mostPointsOfACurve = 1'000'000;
inline constexpr double largestCoordinate = 1e9;

/// How a curve is shown, and whether hands may touch it: no part of what the curve is.
struct Look {
    bool visible = true;
    bool locked = false;
    int colour = 0; ///< 0 is the usual one; 1 .. curveColours are those of the theme, in turn
    bool isTouchable() const { return visible && !locked; }
    bool operator==(const Look&) const = default;
};
inline constexpr int curveColours = 7;

/// How the handles beside an anchor of a Bézier spline hang together.
enum class HandleMode {
    corner,   ///< each by itself
    aligned,  ///< in line, of different lengths
    mirrored, ///< in line, of one length
    automatic ///< where the neighbouring anchors put them
};

/// Modes of anchors, by index, where they are not those that the handles' places show.
using HandleModes = std::map<std::size_t, HandleMode>;

/// A curve in a document, and how hands work on it there. Reads like a pointer to the curve;
/// another curve put in its place leaves the rest as it is.
struct CurveEntry {
    template <std::convertible_to<std::shared_ptr<const Curve>> Pointer>
    CurveEntry(Pointer pointer) : curve(std::move(pointer)) {}
    template <std::convertible_to<std::shared_ptr<const Curve>> Pointer>
    CurveEntry& operator=(Pointer pointer) {
        curve = std::move(pointer);
        return *this;
    }

    const Curve& operator*() const { return *curve; }
    const Curve* operator->() const { return curve.get(); }
    /// Equal where the curves are, shared or not.
    bool operator==(const CurveEntry& other) const;

    std::shared_ptr<const Curve> curve;
    Look look;
    HandleModes handleModes;
};

/// Curves in the order in which they are drawn.
struct Document {
    std::vector<CurveEntry> curves;
    /// What other programs keep in the file: JSON text of one object, carried along untouched.
    std::string extras = "{}";

    bool operator==(const Document&) const = default;
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

/// The same after a change of a document without problem, of which only what differs is looked at:
/// not the curves that both have in common, and of a curve of which only points and tangents are
/// elsewhere, nothing but these.
std::optional<Problem> problemOf(const Document& document, const Document& sound);

} // namespace splineloft
