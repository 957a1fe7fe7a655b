// What is special about editing a Bézier spline: its points are anchors and their handles.
#pragma once

#include "core/spline/curve.h"

#include <optional>
#include <set>

namespace splineloft {

/// Whether the curve's points are anchors and handles.
bool hasHandles(const Curve& curve);

/// The anchor beside which a handle stands, if `index` is one.
std::optional<std::size_t> anchorOf(const Curve& curve, std::size_t index);

/// The handle on the other side of a handle's anchor, if there is one.
std::optional<std::size_t> partnerOf(const Curve& curve, std::size_t handle);

/// The handles beside an anchor: none, one or two.
std::set<std::size_t> handlesOf(const Curve& curve, std::size_t anchor);

/// Turns the partner of a handle that was moved, so that both are in line with their anchor if they
/// were so before; unless one of them was moved too.
void keepInLine(const Curve& before, Curve& after, std::size_t handle,
                const std::set<std::size_t>& moved);

/// Cuts a piece in two with de Casteljau's ladder: the sides of the ladder are the Bézier points of
/// the halves. Returns the index of the new anchor.
std::size_t cutPiece(Curve& curve, Spot spot);

/// Adds an anchor after the last, with the two handles in between: straight, or on along a handle
/// that was pulled out of its line.
void appendAnchor(Curve& curve, const Point& place);

/// Deletes points: anchors go with their handles, a handle alone is drawn in to its anchor.
void deleteAnchorsAndHandles(Curve& curve, const std::set<std::size_t>& indices);

/// Adds the two handles of the piece that closes the curve, or takes them away.
void fitHandlesToClosing(Curve& curve, bool closed);

} // namespace splineloft
