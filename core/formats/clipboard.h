// Curves as text on the clipboard: out as a document of our own, in from whatever people copy.
#pragma once

#include "core/document/document.h"
#include "core/formats/result.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace splineloft {

/// The text of a document with these curves, in the order of the document.
std::string copiedCurves(const Document& document, std::span<const std::size_t> curves);

/// The text of a document with the curves of these points, each with the selected ones only, and
/// what belongs to them. Of a Bézier spline anchors come with their handles. A curve of which not
/// all points are copied is open and has no knots of its own.
std::string copiedPoints(const Document& document, std::span<const PointId> ids);

/// What was on the clipboard.
struct Pasted {
    std::vector<CurveEntry> curves;
};

/// The curves that a text describes: a document, a single curve of one as a JSON object, a JSON
/// array of points, lines of numbers as spreadsheets copy them, SVG path data, or the text of an
/// SVG file. Points become a curve of the usual family. Paths come upright, y up, mirrored about
/// the middle of what they cover. A refusal says at which line and column, or JSON pointer, or
/// byte.
Result<Pasted> pasted(std::string_view text);

} // namespace splineloft
