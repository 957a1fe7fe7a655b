// Edits of whole curves: functions from document to document, as in edits.h. Those that may be
// impossible answer with the problem in its place, at a JSON pointer of the document.
#pragma once

#include "core/document/document.h"

#include <span>
#include <string>
#include <variant>

namespace splineloft {

/// A copy of the curve, right after it.
Document duplicateCurve(const Document& document, std::size_t curve);

/// The curve run through backwards: the shape stays where the family can draw it backwards, which
/// all do but a beta-spline with a bias of its own at each point.
Document reverseCurve(const Document& document, std::size_t curve);

/// Two open curves as one: from the one end, the other curve follows. The result stands in the
/// place of the curve of `end`, and has its name, look and direction; the other curve is gone. Ends
/// that coincide become one point; otherwise a leg leads from end to end. The other curve is
/// converted where its family is another. Bézier splines, B-splines, NURBS and polygons keep their
/// shape; curves whose points pull beyond their neighbours change near the joint.
std::variant<Document, Problem> joinCurves(const Document& document, PointId end, PointId otherEnd);

/// Two curves in the place of one, of the same shape: numbers `curve` and `curve` + 1. A closed
/// curve is opened there. Where the family cannot end at the spot, both are of one that can: Bézier
/// splines, or B-splines or NURBS for degrees beyond 3.
std::variant<Document, Problem> splitCurve(const Document& document, std::size_t curve, Spot spot);

/// The same where the curve passes by a control point, the anchor of a handle.
std::variant<Document, Problem> splitCurve(const Document& document, PointId point);

/// A closed curve opened where it passes by the control point, of the same shape: that is where it
/// then starts and ends.
std::variant<Document, Problem> openAt(const Document& document, PointId point);

/// Draws a curve at another time: the one numbered `from` becomes number `to`.
Document moveCurve(const Document& document, std::size_t from, std::size_t to);

Document renameCurve(const Document& document, std::size_t curve, std::string name);

Document setLook(const Document& document, std::size_t curve, const Look& look);

/// Removes curves; numbers without a curve are passed over.
Document removeCurves(const Document& document, std::span<const std::size_t> curves);

} // namespace splineloft
