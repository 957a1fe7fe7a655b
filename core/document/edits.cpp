#include "core/document/edits.h"

#include "core/document/change.h"
#include "core/document/lists.h"
#include "core/document/tangents.h"
#include "core/document/tidy.h"
#include "core/spline/change/knots.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace splineloft {
namespace {

/// `delta` with as many coordinates as `dimension`.
Point fitted(const Point& delta, int dimension) {
    Point result(dimension);
    for (int c = 0; c < std::min(dimension, delta.dimension()); ++c) {
        result[c] = delta[c];
    }
    return result;
}

Point movedBy(Point place, const Point& delta) {
    for (int c = 0; c < place.dimension(); ++c) {
        place[c] = cleanSum(place[c], delta[c]);
    }
    return place;
}

/// Moves points of `curve`, which is a copy of `before`.
void movePointsOf(const Curve& before, Curve& curve, HandleModes& modes,
                  const std::vector<PointId>& ids, const Point& delta) {
    for (const auto& id : ids) {
        if (id.part == Part::tangent) {
            curve.tangents.set(id.index, movedBy(before.tangents.at(id.index), delta));
        }
    }
    const auto moved = withTheirHandles(curve, ids);
    for (const auto index : moved) {
        curve.points.set(index, movedBy(before.points.at(index), delta));
    }
    keepPartners(before, curve, modes, moved);
}

/// Which index a point added at a spot should get.
std::size_t indexForSpot(const Curve& curve, Spot spot) {
    const auto layout = layoutOf(curve);
    if (layout.stride > 1) { // a piece's points are spread over the whole of it
        const auto legs = static_cast<std::size_t>(layout.window - 1);
        const auto leg = static_cast<std::size_t>(spot.u * static_cast<double>(legs));
        return spot.segment * static_cast<std::size_t>(layout.stride) + 1 + std::min(leg, legs - 1);
    }
    const bool secondHalf = layout.degree % 2 == 0 && spot.u > 0.5;
    return std::min(controlAtStart(curve, spot.segment) + 1 + (secondHalf ? 1 : 0),
                    curve.points.size());
}

/// Whether the curve is its own control polygon, piece by piece.
bool isPolygon(const Curve& curve) {
    const auto layout = layoutOf(curve);
    return layout.degree == 1 && layout.stride == 1;
}

Points without(const Points& points, const std::set<std::size_t>& indices) {
    Points kept(points.dimension());
    kept.reserve(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (!indices.contains(i)) {
            kept.append(points.at(i));
        }
    }
    return kept;
}

Inserted insertAnchor(const Document& document, std::size_t curve, Spot spot) {
    std::size_t anchor = 0;
    bool followed = false; // by automatic handles
    Document next = changed(document, curve, [&](Curve& changing, HandleModes& modes) {
        anchor = cutPiece(changing, spot);
        followed = makeRoomForMode(changing, modes, anchor);
    });
    return {std::move(next), {curve, anchor}, !followed};
}

/// The control point whose knots have their mean nearest to t.
std::size_t controlNear(const Curve& curve, const Pieces& pieces, double t) {
    const double period = pieces.knots().end() - pieces.knots().start();
    const auto means = abscissae(curve);
    const auto away = [&](double mean) {
        const double way = std::abs(mean - t);
        return curve.closed ? std::min(way, std::abs(way - period)) : way;
    };
    const auto nearest =
        std::ranges::min_element(means, {}, [&](double mean) { return away(mean); });
    return static_cast<std::size_t>(nearest - means.begin());
}

/// Nothing where the spot has all the knots that it can have.
std::optional<Inserted> insertKnot(const Document& document, std::size_t curve, Spot spot) {
    const Pieces pieces = piecesOf(*document.curves[curve]);
    const double t = pieces.knots().parameter(spot);
    const auto knotted = withKnot(*document.curves[curve], t);
    const auto* refined = std::get_if<Curve>(&knotted);
    if (refined == nullptr) {
        return std::nullopt;
    }
    Document next = changed(document, curve, [&](Curve& changing) { changing = *refined; });
    return Inserted{std::move(next), {curve, controlNear(*refined, pieces, t)}, true};
}

} // namespace

Document movePoints(const Document& document, std::span<const PointId> ids, const Point& delta) {
    Document next = document;
    for (std::size_t i = 0; i < document.curves.size(); ++i) {
        std::vector<PointId> own;
        std::ranges::copy_if(ids, std::back_inserter(own),
                             [i](const PointId& id) { return id.curve == i; });
        if (!own.empty()) {
            next = changed(next, i, [&](Curve& curve, HandleModes& modes) {
                movePointsOf(*document.curves[i], curve, modes, own,
                             fitted(delta, curve.points.dimension()));
            });
        }
    }
    return next;
}

Document setPoint(const Document& document, const PointId& id, const Point& place) {
    return changed(document, id.curve, [&](Curve& curve, HandleModes& modes) {
        (id.part == Part::point ? curve.points : curve.tangents).set(id.index, place);
        if (const auto anchor = anchorOf(curve, id.index)) {
            loosen(modes, *anchor);
        }
    });
}

Document insertPoint(const Document& document, std::size_t curve, std::size_t before,
                     const Point& place) {
    return changed(document, curve, [&](Curve& changing, HandleModes& modes) {
        changing.points.insert(before, place);
        modes.clear(); // anchors are handles now, and handles anchors
        addToLists(changing, before);
        if (familyOf(changing).usesTangents) {
            const auto all = catmullRomTangents(changing.points, changing.closed);
            changing.tangents.insert(before, all.at(before));
        }
    });
}

bool insertionKeepsShape(const Curve& curve) {
    return hasHandles(curve) || familyOf(curve).usesKnots || isPolygon(curve);
}

Inserted insertOnCurve(const Document& document, std::size_t curve, Spot spot) {
    const Curve& old = *document.curves[curve];
    if (hasHandles(old)) {
        return insertAnchor(document, curve, spot);
    }
    if (familyOf(old).usesKnots) {
        if (auto inserted = insertKnot(document, curve, spot)) {
            return *inserted;
        }
    }
    const Jet jet = piecesOf(old).jet(spot);
    const auto index = indexForSpot(old, spot);
    Document next = insertPoint(document, curve, index, jet.position);
    if (familyOf(old).usesTangents) {
        // Two pieces where there was one: each runs through its half at half the speed.
        next = setPoint(next, {curve, index, Part::tangent}, 0.5 * jet.first);
    }
    return {std::move(next), {curve, index}, isPolygon(old)};
}

Inserted appendPoint(const Document& document, std::size_t curve, const Point& place) {
    const Curve& old = *document.curves[curve];
    const auto n = old.points.size();
    if (!hasHandles(old) || n == 0 || old.closed) {
        return {insertPoint(document, curve, n, place), {curve, n}};
    }
    Document next = changed(document, curve, [&](Curve& changing, HandleModes& modes) {
        const auto before = lastAnchor(changing);
        appendAnchor(changing, place);
        continueMode(modes, before, changing.points.size() - 1);
    });
    const auto last = next.curves[curve]->points.size() - 1;
    return {std::move(next), {curve, last}};
}

Document startHandle(const Document& document, std::size_t curve, const Point& place) {
    return changed(document, curve,
                   [&](Curve& changing, HandleModes&) { changing.points.append(place); });
}

Document deletePoints(const Document& document, std::span<const PointId> ids) {
    Document next = document;
    for (std::size_t i = document.curves.size(); i-- > 0;) {
        std::set<std::size_t> indices;
        for (const auto& id : ids) {
            if (id.curve == i && id.part == Part::point) {
                indices.insert(id.index);
            }
        }
        if (indices.empty()) {
            continue;
        }
        next = changed(next, i, [&](Curve& curve, HandleModes& modes) {
            if (hasHandles(curve)) {
                deleteAnchorsAndHandles(curve, modes, indices);
                return;
            }
            curve.points = without(curve.points, indices);
            removeFromLists(curve, indices);
            if (!curve.tangents.empty()) {
                curve.tangents = without(curve.tangents, indices);
            }
        });
        if (next.curves[i]->points.empty()) {
            next = removeCurve(next, i);
        }
    }
    return next;
}

Document addCurve(const Document& document, Curve curve) {
    Document next = document;
    next.curves.push_back(std::make_shared<Curve>(std::move(curve)));
    return next;
}

Document removeCurve(const Document& document, std::size_t curve) {
    Document next = document;
    next.curves.erase(next.curves.begin() + static_cast<std::ptrdiff_t>(curve));
    return next;
}

} // namespace splineloft
