// Curves cut in two, and closed ones cut open.
#include "core/document/curve_edits.h"
#include "core/document/excerpt.h"
#include "core/document/handles.h"
#include "core/spline/change/convert.h"
#include "core/spline/change/knots.h"
#include "core/spline/change/shape.h"
#include "core/spline/measure/nearest.h"
#include "core/spline/shape/subdivide.h"

#include <array>
#include <cmath>

namespace splineloft {
namespace {

// A spot this near to a joint, by u, is the joint.
constexpr double atJoint = 1e-12;

/// A curve with a joint at the spot where it is to be cut.
struct Jointed {
    Curve curve;
    std::size_t joint; ///< number of the piece that begins there
    bool isNew;
};

/// The curve with a joint at the spot, where its family can have one anywhere.
std::optional<Jointed> withJoint(const Curve& curve, const Pieces& pieces, Spot spot) {
    if (spot.u < atJoint || spot.u > 1 - atJoint) {
        return Jointed{curve, spot.segment + (spot.u < 0.5 ? 0 : 1), false};
    }
    const auto joint = spot.segment + 1;
    const auto layout = layoutOf(curve);
    if (familyOf(curve).usesKnots) {
        const auto result = withKnot(curve, pieces.knots().parameter(spot));
        const auto* refined = std::get_if<Curve>(&result);
        return refined == nullptr ? std::nullopt : std::optional(Jointed{*refined, joint, true});
    }
    Jointed result{curve, joint, true};
    if (hasHandles(curve)) {
        cutPiece(result.curve, spot);
        return result;
    }
    if (layout.degree == 1 && layout.stride == 1) { // a polygon
        result.curve.points.insert(joint, pieces.position(spot));
        return result;
    }
    return std::nullopt;
}

Curve clampedIfPossible(const Curve& curve) {
    return familyOf(curve).usesKnots ? clampedAtEnds(curve).value_or(curve) : curve;
}

/// What a cut leaves of a curve.
struct Parts {
    std::vector<Curve> curves; ///< one of a closed curve, two of an open one
    std::size_t joint = 0;     ///< of the curve that was cut
    bool isNew = false;        ///< the joint was
};

/// The halves of a curve that is its own Bézier polygon.
Parts halvesOf(const Curve& curve, const Piece& piece, double u) {
    const auto [before, after] = halved(piece, u);
    Parts parts;
    for (const auto& numbers : {before, after}) {
        Curve half = curve;
        half.points = Points(curve.points.dimension());
        const auto width = static_cast<std::size_t>(piece.width());
        for (std::size_t i = 0; i + width <= numbers.size(); i += width) {
            half.points.append(Point(std::span(numbers).subspan(i, width)));
        }
        parts.curves.push_back(std::move(half));
    }
    return parts;
}

std::optional<Parts> cut(const Curve& curve, Spot spot) {
    const Pieces pieces = piecesOf(curve);
    if (curve.family == "bezier") {
        return halvesOf(curve, pieces[0], spot.u);
    }
    const auto jointed = withJoint(curve, pieces, spot);
    if (!jointed) {
        return std::nullopt;
    }
    const auto& [whole, joint, isNew] = *jointed;
    const auto count = pieces.size() + (isNew ? 1 : 0);
    Parts parts{{}, joint, isNew};
    const auto add = [&whole = whole, &parts](std::size_t first, std::size_t pieceCount) {
        if (const auto part = excerpt(whole, first, pieceCount)) {
            parts.curves.push_back(clampedIfPossible(*part));
        }
    };
    if (curve.closed) {
        add(joint % count, count);
        return parts.curves.size() == 1 ? std::optional(parts) : std::nullopt;
    }
    add(0, joint);
    add(joint, count - joint);
    return parts.curves.size() == 2 ? std::optional(parts) : std::nullopt;
}

/// The modes of the handles of one part, whose first anchor was number `first` of the curve with
/// its new joint. Automatic handles beside the cut stay where they are.
HandleModes modesOf(const HandleModes& modes, const Parts& parts, const Curve& part,
                    std::size_t first, std::size_t around) {
    const auto cutAt = 3 * parts.joint;
    const auto nearCut = [&](std::size_t anchor) {
        return anchor + 3 >= cutAt && anchor <= cutAt + 3;
    };
    HandleModes lasting = renumbered(modes, [&](std::size_t old) {
        return std::optional(parts.isNew && old >= cutAt ? old + 3 : old);
    });
    std::erase_if(lasting, [&](const auto& entry) {
        return entry.second == HandleMode::automatic &&
               (nearCut(entry.first) || nearCut(entry.first + around));
    });
    return renumbered(lasting, [&](std::size_t anchor) -> std::optional<std::size_t> {
        const auto own = anchor >= first ? anchor - first : anchor + around - first;
        const bool isHere = (anchor >= first || around > 0) && own < part.points.size();
        return isHere ? std::optional(own) : std::nullopt;
    });
}

std::string placeOf(std::size_t curve) {
    return "/curves/" + std::to_string(curve);
}

/// The parts of the curve, of the first family that is the same curve and can be cut there.
std::optional<Parts> cutInSomeFamily(const Curve& curve, Spot spot) {
    for (const std::string_view family :
         {std::string_view(curve.family), std::string_view("bezier-spline"),
          std::string_view("bezier"), std::string_view("b-spline"), std::string_view("nurbs")}) {
        const auto same = converted(curve, family);
        if (const auto* found = std::get_if<Curve>(&same)) {
            if (auto parts = cut(*found, spot)) {
                return parts;
            }
        }
    }
    return std::nullopt;
}

std::variant<Document, Problem> cutAt(const Document& document, std::size_t index, Spot spot) {
    const CurveEntry& entry = document.curves[index];
    auto parts = cutInSomeFamily(*entry, spot);
    if (!parts) {
        return Problem{placeOf(index) + "/family",
                       "a curve of the family " + entry->family + " cannot be cut here",
                       "at one of its control points, or a Bézier spline"};
    }
    Document next = document;
    const auto place = next.curves.erase(next.curves.begin() + static_cast<std::ptrdiff_t>(index));
    std::vector<CurveEntry> added;
    for (auto& part : parts->curves) {
        CurveEntry own = entry;
        const bool second = !added.empty();
        const auto around = entry->closed ? part.points.size() - 1 : 0;
        const auto first = second || entry->closed ? 3 * parts->joint : 0;
        own.handleModes = modesOf(entry.handleModes, *parts, part, first, around);
        part.name += second ? " 2" : "";
        settleModes(part, own.handleModes);
        own = std::make_shared<Curve>(std::move(part));
        added.push_back(std::move(own));
    }
    next.curves.insert(place, added.begin(), added.end());
    return next;
}

/// Where the curve passes by a control point; through it, where it does.
Spot spotOf(const Curve& curve, const Pieces& pieces, std::size_t control) {
    const auto& line = pieces.knots();
    double t = abscissae(curve)[anchorOf(curve, control).value_or(control)];
    if (curve.closed) {
        const double period = line.end() - line.start();
        t -= std::floor((t - line.start()) / period) * period;
    }
    const Spot spot = line.locate(t);
    const Point place = curve.points.at(control);
    const double tolerance = conversion::toleranceOf(pieces);
    if (distance(pieces.position(spot), place) > tolerance) { // not evenly spaced on its piece
        const Pieces piece = part(pieces, {spot.segment, 0}, {spot.segment, 1});
        const auto through = nearestTo(piece, place, tolerance);
        return through ? Spot{spot.segment, through->spot.u} : spot;
    }
    return spot;
}

} // namespace

std::variant<Document, Problem> splitCurve(const Document& document, std::size_t curve, Spot spot) {
    const Curve& old = *document.curves[curve];
    const auto count = piecesOf(old).size();
    const bool atStart = count == 0 || (spot.segment == 0 && spot.u < atJoint);
    const bool atEnd = spot.segment + 1 >= count && spot.u > 1 - atJoint;
    if (count == 0 || (!old.closed && (atStart || atEnd))) {
        return Problem{placeOf(curve),
                       count == 0 ? "has too few points for a piece" : "ends there already",
                       "a spot between the ends of the curve"};
    }
    return cutAt(document, curve, spot);
}

std::variant<Document, Problem> splitCurve(const Document& document, PointId point) {
    const Curve& curve = *document.curves[point.curve];
    const Pieces pieces = piecesOf(curve);
    return splitCurve(document, point.curve,
                      pieces.empty() ? Spot{} : spotOf(curve, pieces, point.index));
}

std::variant<Document, Problem> openAt(const Document& document, PointId point) {
    if (!document.curves[point.curve]->closed) {
        return Problem{placeOf(point.curve) + "/closed", "is an open curve already",
                       "a closed curve"};
    }
    return splitCurve(document, point);
}

} // namespace splineloft
