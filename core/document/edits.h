// What a person does to a document: functions from document to document. None of them draws, asks
// or remembers; a drag calls the same one again and again with its total displacement.
#pragma once

#include "core/document/document.h"

#include <span>
#include <string>

namespace splineloft {

/// Moves control points, and tips of tangents, by `delta`; coordinates that a curve lacks are left
/// out. Sums are rounded to 14 digits, so that 0.1 moved by 0.2 lies at 0.3. In a Bézier spline an
/// anchor takes its handles with it, and a handle turns its partner along where the two were in
/// line.
Document movePoints(const Document& document, std::span<const PointId> ids, const Point& delta);

/// Puts one control point at `place`, or gives a tangent that value. Nothing else moves.
Document setPoint(const Document& document, const PointId& id, const Point& place);

/// Puts a new control point at `place` before the one numbered `before` (or at the end).
Document insertPoint(const Document& document, std::size_t curve, std::size_t before,
                     const Point& place);

/// A document and the control point that was added to it.
struct Inserted {
    Document document;
    PointId point;
};

/// Adds a control point at a spot of the curve. In a Bézier spline the piece is cut there and keeps
/// its shape; elsewhere the new point lands on the old curve.
Inserted insertOnCurve(const Document& document, std::size_t curve, Spot spot);

/// Adds a control point after the last; a Bézier spline also gets the two handles in between.
Inserted appendPoint(const Document& document, std::size_t curve, const Point& place);

/// Deletes control points, and every curve that has none left. In a Bézier spline an anchor goes
/// with its handles, and a handle alone is drawn in to its anchor.
Document deletePoints(const Document& document, std::span<const PointId> ids);

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
