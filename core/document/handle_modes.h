// How the handles beside an anchor of a Bézier spline hang together, and how that is kept while the
// curve is edited.
//
// A mode is stored only where it is not what the handles' places show. So a curve that comes from
// anywhere has modes, and most curves store none.
#pragma once

#include "core/document/document.h"

#include <span>
#include <string_view>

namespace splineloft {

/// The mode of an anchor: the one stored, or what the handles show: mirrored where they are in line
/// and equally long, aligned where they are in line, otherwise corner. An anchor with one handle
/// shows a corner.
HandleMode modeOf(const CurveEntry& entry, std::size_t anchor);

/// Gives the anchors among these points, and those of the handles among them, a mode, and moves
/// their handles so that it holds: aligned turns both onto their mean direction, mirrored also
/// makes them as long as their mean, automatic puts them where the neighbouring anchors say, corner
/// leaves them where they are.
Document setHandleMode(const Document& document, std::span<const PointId> ids, HandleMode mode);

/// The mode to which a click leads from this one: corner, aligned, mirrored, automatic, corner.
HandleMode nextHandleMode(HandleMode mode);

/// Name of a mode, as in files: "corner", "aligned", "mirrored", "automatic".
std::string_view nameOf(HandleMode mode);

} // namespace splineloft
