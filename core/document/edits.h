// What a person does to a document: functions from document to document. None of them draws, asks
// or remembers; a drag calls the same one again and again with its total displacement.
#pragma once

#include "core/document/document.h"
#include "core/document/plane_map.h"

#include <span>
#include <string>

namespace splineloft {

/// Moves control points, and tips of tangents, by `delta`; coordinates that a curve lacks are left
/// out. Sums are rounded to 14 digits, so that 0.1 moved by 0.2 lies at 0.3. In a Bézier spline an
/// anchor takes its handles with it, and a handle its partner as the mode of their anchor says
/// (handle_modes.h).
Document movePoints(const Document& document, std::span<const PointId> ids, const Point& delta);

/// Maps two coordinates of control points, numbers `across` and `up` (the last one where a curve
/// has fewer). Handles go along with their anchors, tangents with their points by the map's linear
/// part. A curve of one coordinate follows `up` alone, and stays where the map would turn it.
/// Places are rounded to 14 digits.
Document transformPoints(const Document& document, std::span<const PointId> ids,
                         const PlaneMap& map, int across, int up);

/// Puts one control point at `place`, or gives a tangent that value. Nothing else moves.
Document setPoint(const Document& document, const PointId& id, const Point& place);

/// Puts a new control point at `place` before the one numbered `before` (or at the end).
Document insertPoint(const Document& document, std::size_t curve, std::size_t before,
                     const Point& place);

/// A document and the control point that was added to it.
struct Inserted {
    Document document;
    PointId point;
    bool keepsShape = false; ///< the curve still goes where it went
};

/// Whether `insertOnCurve` keeps the shape of such a curve.
bool insertionKeepsShape(const Curve& curve);

/// Adds a control point at a spot of the curve. Bézier splines, whose piece is cut there, B-splines
/// and NURBS, which get a knot there (and so knots of their own), and polygons keep their shape;
/// automatic handles beside the spot follow, all the same. Elsewhere the new point lands on the old
/// curve.
Inserted insertOnCurve(const Document& document, std::size_t curve, Spot spot);

/// Adds a control point after the last; a Bézier spline also gets the two handles in between.
Inserted appendPoint(const Document& document, std::size_t curve, const Point& place);

/// Gives a Bézier spline of a single anchor the handle that leaves it.
Document startHandle(const Document& document, std::size_t curve, const Point& place);

/// Deletes control points, and every curve that has none left. In a Bézier spline an anchor goes
/// with its handles, and a handle alone is drawn in to its anchor.
Document deletePoints(const Document& document, std::span<const PointId> ids);

/// Deletes control points as `deletePoints` does, and moves their neighbours so that the curve
/// stays as near to where it was as it can; never farther than it would be without. In a Bézier
/// spline the two handles of the merged piece change their lengths, in a Hermite curve the
/// neighbouring tangents change, elsewhere a few control points on either side move. The ends of an
/// open curve stay; beyond points deleted at an end there is nothing to heal. Curves of more than
/// 1000 control points are not healed.
Document deleteAndHeal(const Document& document, std::span<const PointId> ids);

/// Draws the same points as another family. Parameters start at their neutral values; closing
/// stays where the family allows it, and so do ends that are not the usual ones of the old family;
/// Hermite tangents start as those of Catmull-Rom. Between a B-spline and NURBS all stays that both
/// have.
Document setFamily(const Document& document, std::size_t curve, std::string_view family);

/// Another value of a B-spline's parameter takes the place of its own knots.
Document setParameter(const Document& document, std::size_t curve, std::string_view key,
                      double value);

/// Gives a parameter a value at each control point, at first the curve's everywhere. No change
/// where its family does not have that.
Document makeLocal(const Document& document, std::size_t curve, std::string_view key);

/// Gives it one value for the whole curve again: that of the points where they agree, otherwise
/// the one that it had before.
Document makeGlobal(const Document& document, std::size_t curve, std::string_view key);

/// Sets a parameter at these control points, or at all where none is named, and makes it local.
Document setLocal(const Document& document, std::size_t curve, std::string_view key,
                  std::span<const std::size_t> points, double value);

/// Gives a control point a weight. Without stored weights all are 1, and where all are 1 none are
/// stored. No change where the family has no weights.
Document setWeight(const Document& document, std::size_t curve, std::size_t point, double weight);

/// Another end takes the place of a B-spline's own knots.
Document setEnds(const Document& document, std::size_t curve, Ends ends);
/// Closing a Bézier spline adds the two handles of its last piece, opening it takes them away.
Document setClosed(const Document& document, std::size_t curve, bool closed);
Document addCurve(const Document& document, Curve curve);
Document removeCurve(const Document& document, std::size_t curve);

} // namespace splineloft
