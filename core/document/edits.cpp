#include "core/document/edits.h"

#include "core/document/handles.h"
#include "core/document/lists.h"
#include "core/spline/catalog.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <set>

namespace splineloft {
namespace {

/// The document with one curve changed by `change`.
template <class Change>
Document changed(const Document& document, std::size_t index, Change change) {
    auto curve = std::make_shared<Curve>(*document.curves[index]);
    change(*curve);
    Document next = document;
    next.curves[index] = std::move(curve);
    return next;
}

/// `delta` with as many coordinates as `dimension`.
Point fitted(const Point& delta, int dimension) {
    Point result(dimension);
    for (int c = 0; c < std::min(dimension, delta.dimension()); ++c) {
        result[c] = delta[c];
    }
    return result;
}

/// a + b without the dust that adding decimals in binary leaves behind: to 14 significant digits.
double cleanSum(double a, double b) {
    if (b == 0) {
        return a;
    }
    std::array<char, 40> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), a + b,
                                   std::chars_format::scientific, 13)
                         .ptr;
    double sum = 0;
    std::from_chars(text.data(), end, sum);
    return sum;
}

Point movedBy(Point place, const Point& delta) {
    for (int c = 0; c < place.dimension(); ++c) {
        place[c] = cleanSum(place[c], delta[c]);
    }
    return place;
}

void movePointsOf(Curve& curve, const std::vector<PointId>& ids, const Point& delta) {
    const Curve before = curve;
    std::set<std::size_t> moved;
    for (const auto& id : ids) {
        if (id.part == Part::tangent) {
            curve.tangents.set(id.index, movedBy(before.tangents.at(id.index), delta));
            continue;
        }
        moved.insert(id.index);
        if (hasHandles(curve) && id.index % 3 == 0) {
            moved.merge(handlesOf(curve, id.index));
        }
    }
    for (const auto index : moved) {
        curve.points.set(index, movedBy(before.points.at(index), delta));
    }
    if (hasHandles(curve)) {
        for (const auto index : moved) {
            keepInLine(before, curve, index, moved);
        }
    }
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

/// Whether the curve's family lets a parameter have a value at each control point.
bool mayBeLocal(const Curve& curve, std::string_view key) {
    const auto& parameters = familyOf(curve).parameters;
    const auto found = std::ranges::find(parameters, key, &Parameter::key);
    return found != parameters.end() && found->local;
}

Points catmullRomTangents(const Points& points, bool closed) {
    Points tangents(points.dimension());
    const auto n = points.size();
    for (std::size_t i = 0; i < n; ++i) {
        const auto before = i > 0 ? i - 1 : closed ? n - 1 : 0;
        const auto after = i + 1 < n ? i + 1 : closed ? 0 : i;
        tangents.append(0.5 * (points.at(after) - points.at(before)));
    }
    return tangents;
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

} // namespace

Document movePoints(const Document& document, std::span<const PointId> ids, const Point& delta) {
    Document next = document;
    for (std::size_t i = 0; i < document.curves.size(); ++i) {
        std::vector<PointId> own;
        std::ranges::copy_if(ids, std::back_inserter(own),
                             [i](const PointId& id) { return id.curve == i; });
        if (!own.empty()) {
            next = changed(next, i, [&](Curve& curve) {
                movePointsOf(curve, own, fitted(delta, curve.points.dimension()));
            });
        }
    }
    return next;
}

Document setPoint(const Document& document, const PointId& id, const Point& place) {
    return changed(document, id.curve, [&](Curve& curve) {
        (id.part == Part::point ? curve.points : curve.tangents).set(id.index, place);
    });
}

Document insertPoint(const Document& document, std::size_t curve, std::size_t before,
                     const Point& place) {
    return changed(document, curve, [&](Curve& changing) {
        changing.points.insert(before, place);
        addToLists(changing, before);
        if (familyOf(changing).usesTangents) {
            const auto all = catmullRomTangents(changing.points, changing.closed);
            changing.tangents.insert(before, all.at(before));
        }
    });
}

Inserted insertOnCurve(const Document& document, std::size_t curve, Spot spot) {
    const Curve& old = *document.curves[curve];
    if (hasHandles(old)) {
        std::size_t anchor = 0;
        Document next =
            changed(document, curve, [&](Curve& changing) { anchor = cutPiece(changing, spot); });
        return {std::move(next), {curve, anchor}};
    }
    const Jet jet = piecesOf(old).jet(spot);
    const auto index = indexForSpot(old, spot);
    Document next = insertPoint(document, curve, index, jet.position);
    if (familyOf(old).usesTangents) {
        // Two pieces where there was one: each runs through its half at half the speed.
        next = setPoint(next, {curve, index, Part::tangent}, 0.5 * jet.first);
    }
    return {std::move(next), {curve, index}};
}

Inserted appendPoint(const Document& document, std::size_t curve, const Point& place) {
    const Curve& old = *document.curves[curve];
    const auto n = old.points.size();
    if (!hasHandles(old) || n == 0 || old.closed) {
        return {insertPoint(document, curve, n, place), {curve, n}};
    }
    Document next =
        changed(document, curve, [&](Curve& changing) { appendAnchor(changing, place); });
    const auto last = next.curves[curve]->points.size() - 1;
    return {std::move(next), {curve, last}};
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
        next = changed(next, i, [&](Curve& curve) {
            if (hasHandles(curve)) {
                deleteAnchorsAndHandles(curve, indices);
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

Document setFamily(const Document& document, std::size_t curve, std::string_view family) {
    const Family* wanted = findFamily(family);
    if (wanted == nullptr || document.curves[curve]->family == family) {
        return document;
    }
    return changed(document, curve, [&](Curve& changing) {
        const Family& before = familyOf(changing);
        const bool usual = changing.ends == before.ends.front();
        changing.family = family;
        changing.closed = changing.closed && wanted->closable;
        dropUnusedLists(changing);
        if (!(before.usesKnots && wanted->usesKnots)) { // of two B-splines all means the same
            changing.parameters.clear(); // elsewhere the same word means something else
            changing.local.clear();
            dropKnots(changing);
            changing.ends = usual ? wanted->ends.front() : changing.ends;
        }
        completeParameters(changing);
        changing.tangents = wanted->usesTangents
                                ? catmullRomTangents(changing.points, changing.closed)
                                : Points(changing.points.dimension());
    });
}

Document setParameter(const Document& document, std::size_t curve, std::string_view key,
                      double value) {
    return changed(document, curve, [&](Curve& changing) {
        const auto before = parameterOf(changing, key);
        changing.parameters[std::string(key)] = value;
        if (familyOf(changing).usesKnots && value != before) {
            dropKnots(changing); // they belong to the degree, and stand in place of a spacing
        }
    });
}

Document makeLocal(const Document& document, std::size_t curve, std::string_view key) {
    const Curve& old = *document.curves[curve];
    if (!mayBeLocal(old, key) || old.local.contains(std::string(key)) || old.points.empty()) {
        return document;
    }
    return changed(document, curve, [&](Curve& changing) {
        changing.local[std::string(key)].assign(old.points.size(), parameterOf(old, key));
    });
}

Document makeGlobal(const Document& document, std::size_t curve, std::string_view key) {
    const auto& local = document.curves[curve]->local;
    const auto found = local.find(std::string(key));
    if (found == local.end()) {
        return document;
    }
    return changed(document, curve, [&](Curve& changing) {
        const auto& values = found->second;
        if (std::ranges::all_of(values, [&](double v) { return v == values.front(); })) {
            changing.parameters[std::string(key)] = values.front();
        }
        changing.local.erase(std::string(key));
    });
}

Document setLocal(const Document& document, std::size_t curve, std::string_view key,
                  std::span<const std::size_t> points, double value) {
    const Document local = makeLocal(document, curve, key);
    if (!local.curves[curve]->local.contains(std::string(key))) {
        return document;
    }
    return changed(local, curve, [&](Curve& changing) {
        auto& values = changing.local.at(std::string(key));
        for (const auto index : points) {
            if (index < values.size()) {
                values[index] = value;
            }
        }
        if (points.empty()) {
            std::ranges::fill(values, value);
        }
    });
}

Document setWeight(const Document& document, std::size_t curve, std::size_t point, double weight) {
    const Curve& old = *document.curves[curve];
    if (!familyOf(old).usesWeights || point >= old.points.size()) {
        return document;
    }
    return changed(document, curve, [&](Curve& changing) {
        auto& weights = changing.weights;
        weights.resize(changing.points.size(), 1);
        weights[point] = weight;
        if (std::ranges::all_of(weights, [](double w) { return w == 1; })) {
            weights.clear();
        }
    });
}

Document setEnds(const Document& document, std::size_t curve, Ends ends) {
    return changed(document, curve, [&](Curve& changing) {
        changing.ends = ends;
        dropKnots(changing);
    });
}

Document setClosed(const Document& document, std::size_t curve, bool closed) {
    return changed(document, curve, [&](Curve& changing) {
        if (hasHandles(changing)) {
            fitHandlesToClosing(changing, closed);
        }
        if (changing.closed != closed) {
            changing.closed = closed;
            dropKnots(changing); // an open curve has others than a closed one
        }
    });
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
