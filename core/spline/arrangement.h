// How a curve begins, stops or closes, arranged once for all families: the control points are
// extended at the ends or around the loop, and every arranged point gets its parameter value.
#pragma once

#include "core/spline/curve.h"
#include "core/spline/ranges.h"

#include <span>
#include <vector>

namespace splineloft {

/// One arranged point: a control point, or its mirror image beyond one of the two ends.
struct Place {
    std::size_t control = 0;
    std::optional<std::size_t> mirroredAt; ///< the end point: the place is 2 P[end] - P[control]
};

/// The control points in the order in which the pieces read them.
struct Arrangement {
    Layout layout;
    std::vector<Place> places;
    std::vector<std::size_t> windows; ///< where the window of each piece begins among the places
    std::size_t before = 0;           ///< places that stand before control point 0
    std::vector<double> knots;        ///< as `Input::knots`
    std::vector<double> intervals;    ///< as `Input::intervals`
    KnotLine joints;                  ///< parameter values where the pieces meet
    /// Where chords space the knots: what they measure, to the power alpha, before what is below
    /// rounding was dropped.
    std::vector<double> chords;

    std::size_t pieces() const { return windows.size(); }
};

/// Arranges the control points of a curve that has no problem.
Arrangement arrangementOf(const Spline& spline, const PointsView& points);

/// The places at which some control points stand, or that are made from them.
std::vector<Range> placesOf(const Arrangement& arrangement, std::span<const Range> controls);

/// Brings the knots of an arrangement that chords space, but not its joints, up to date after the
/// points at some places have moved. Returns the intervals that have changed.
std::vector<Range> respace(Arrangement& arrangement, const Spline& spline, const PointsView& points,
                           std::span<const Range> moved);

/// The value of an arranged place, from those of the controls.
template <Blendable T> T valueAt(const Place& place, std::span<const T> controls) {
    const T& own = controls[place.control];
    return place.mirroredAt ? T(2.0 * controls[*place.mirroredAt] - own) : own;
}

/// The values of all arranged places.
template <Blendable T>
std::vector<T> arranged(const std::vector<Place>& places, std::span<const T> controls) {
    std::vector<T> values;
    values.reserve(places.size());
    for (const auto& place : places) {
        values.push_back(valueAt(place, controls));
    }
    return values;
}

} // namespace splineloft
