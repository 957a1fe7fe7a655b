// What is special about editing a Bézier spline: its points are anchors and their handles.
#pragma once

#include "core/document/document.h"

#include <optional>
#include <set>
#include <span>

namespace splineloft {

/// Whether the curve's points are anchors and handles.
bool hasHandles(const Curve& curve);

/// The anchor beside which a handle stands, if `index` is one.
std::optional<std::size_t> anchorOf(const Curve& curve, std::size_t index);

/// The handle on the other side of a handle's anchor, if there is one.
std::optional<std::size_t> partnerOf(const Curve& curve, std::size_t handle);

/// The handles beside an anchor: none, one or two.
std::set<std::size_t> handlesOf(const Curve& curve, std::size_t anchor);

/// The anchors from which a piece leads to this one, and to which one leads from it.
std::optional<std::size_t> anchorBefore(const Curve& curve, std::size_t anchor);
std::optional<std::size_t> anchorAfter(const Curve& curve, std::size_t anchor);

/// The control points among `ids`, with the handles of the anchors among them.
std::set<std::size_t> withTheirHandles(const Curve& curve, std::span<const PointId> ids);

/// The mode that the handles beside an anchor show by their places: corner, aligned or mirrored.
HandleMode shownMode(const Curve& curve, std::size_t anchor);

/// Moves the partners of handles that were moved alone as the modes of their anchors ask. An
/// automatic anchor of which a handle was moved is aligned from then on.
void keepPartners(const Curve& before, Curve& after, HandleModes& modes,
                  const std::set<std::size_t>& moved);

/// Puts automatic handles where the neighbouring anchors say, and forgets the modes that the
/// handles show by themselves or that there is no anchor for.
void settleModes(Curve& curve, HandleModes& modes);

/// A handle of the anchor was put where its mode may not hold: what its handles show counts again,
/// unless it was a corner.
void loosen(HandleModes& modes, std::size_t anchor);

/// Numbers the modes of a curve in which `anchor` is new; between two automatic anchors it is
/// automatic, too. Returns whether an automatic anchor stands beside it.
bool makeRoomForMode(const Curve& curve, HandleModes& modes, std::size_t anchor);

/// The anchor `added` at the end is automatic if the one before it is.
void continueMode(HandleModes& modes, std::size_t last, std::size_t added);

/// The modes under other numbers: `number(anchor)` is the new one, or nothing where it is gone.
template <class Number> HandleModes renumbered(const HandleModes& modes, Number number) {
    HandleModes result;
    for (const auto& [anchor, mode] : modes) {
        if (const std::optional<std::size_t> now = number(anchor)) {
            result[*now] = mode;
        }
    }
    return result;
}

/// Cuts a piece in two with de Casteljau's ladder: the sides of the ladder are the Bézier points of
/// the halves. Returns the index of the new anchor.
std::size_t cutPiece(Curve& curve, Spot spot);

/// The last anchor of an open curve with handles, which has at least one. Handles may follow it.
std::size_t lastAnchor(const Curve& curve);

/// Adds an anchor after the last, with those of the two handles in between that are not there yet:
/// straight, or on along a handle that was pulled out of its line.
void appendAnchor(Curve& curve, const Point& place);

/// Deletes points: anchors go with their handles, a handle alone is drawn in to its anchor.
void deleteAnchorsAndHandles(Curve& curve, HandleModes& modes,
                             const std::set<std::size_t>& indices);

/// Adds the two handles of the piece that closes the curve, or takes them away.
void fitHandlesToClosing(Curve& curve, bool closed);

} // namespace splineloft
