#include "core/document/handles.h"

#include <algorithm>
#include <array>
#include <vector>

namespace splineloft {
namespace {

/// An anchor of a Bézier spline with the handles that arrive and leave.
struct Node {
    Point arriving, anchor, leaving;
};

std::vector<Node> nodesOf(const Curve& curve) {
    std::vector<Node> nodes;
    const auto n = curve.points.size();
    for (std::size_t i = 0; i < n; i += 3) {
        const Point anchor = curve.points.at(i);
        const bool wraps = i == 0 && curve.closed;
        nodes.push_back({i > 0   ? curve.points.at(i - 1)
                         : wraps ? curve.points.at(n - 1)
                                 : anchor,
                         anchor, i + 1 < n ? curve.points.at(i + 1) : anchor});
    }
    return nodes;
}

/// The control points of a Bézier spline through these nodes.
Points pointsThrough(const std::vector<Node>& nodes, const Curve& curve) {
    Points points(curve.points.dimension());
    for (std::size_t k = 0; k < nodes.size(); ++k) {
        if (k > 0) {
            points.append(nodes[k].arriving);
        }
        points.append(nodes[k].anchor);
        if (k + 1 < nodes.size() || curve.closed) {
            points.append(nodes[k].leaving);
        }
    }
    if (curve.closed && !nodes.empty()) {
        points.append(nodes.front().arriving);
    }
    return points;
}

/// Where the handle leaving the last anchor of a Bézier spline goes, from the anchor, when the next
/// anchor is `step` away: straight there, unless the handle arriving was pulled out of its line, as
/// the pen does; then on along it.
Point onward(const Curve& curve, const Point& step) {
    const auto n = curve.points.size();
    if (n >= 4) {
        const Point anchor = curve.points.at(n - 1);
        const Point arriving = anchor - curve.points.at(n - 2);
        const Point straight = (1.0 / 3) * (anchor - curve.points.at(n - 4));
        if (distance(arriving, straight) > 1e-9 * norm(straight)) {
            return arriving;
        }
    }
    return (1.0 / 3) * step;
}

} // namespace

bool hasHandles(const Curve& curve) {
    return familyOf(curve).hasHandles;
}

std::optional<std::size_t> anchorOf(const Curve& curve, std::size_t index) {
    if (!hasHandles(curve) || index % 3 == 0) {
        return std::nullopt;
    }
    const auto anchor = index % 3 == 1 ? index - 1 : index + 1;
    if (anchor < curve.points.size()) {
        return anchor;
    }
    return curve.closed ? std::optional<std::size_t>(0) : std::nullopt;
}

std::optional<std::size_t> partnerOf(const Curve& curve, std::size_t handle) {
    const auto anchor = anchorOf(curve, handle);
    if (!anchor) {
        return std::nullopt;
    }
    const auto n = curve.points.size();
    if (handle % 3 == 2) {
        const auto partner = *anchor + 1;
        return partner < n ? std::optional(partner) : std::nullopt;
    }
    if (*anchor > 0) {
        return *anchor - 1;
    }
    return curve.closed ? std::optional(n - 1) : std::nullopt;
}

std::set<std::size_t> handlesOf(const Curve& curve, std::size_t anchor) {
    const auto n = curve.points.size();
    std::set<std::size_t> handles;
    for (const auto index : {anchor + 1, anchor > 0 ? anchor - 1 : n - 1}) {
        if (index < n && anchorOf(curve, index) == anchor) {
            handles.insert(index);
        }
    }
    return handles;
}

std::optional<std::size_t> anchorBefore(const Curve& curve, std::size_t anchor) {
    const auto n = curve.points.size();
    if (anchor >= 3) {
        return anchor - 3;
    }
    return curve.closed && n > 0 && n % 3 == 0 ? std::optional(n - 3) : std::nullopt;
}

std::optional<std::size_t> anchorAfter(const Curve& curve, std::size_t anchor) {
    const auto n = curve.points.size();
    if (anchor + 3 < n) {
        return anchor + 3;
    }
    return curve.closed && anchor + 3 == n ? std::optional<std::size_t>(0) : std::nullopt;
}

std::set<std::size_t> withTheirHandles(const Curve& curve, std::span<const PointId> ids) {
    std::set<std::size_t> points;
    for (const auto& id : ids) {
        if (id.part == Part::tangent) {
            continue;
        }
        points.insert(points.end(), id.index); // they mostly come in order
        if (hasHandles(curve) && id.index % 3 == 0) {
            points.merge(handlesOf(curve, id.index));
        }
    }
    return points;
}

std::size_t cutPiece(Curve& curve, Spot spot) {
    const auto ladder = piecesOf(curve)[spot.segment].ladder(spot.u);
    const auto first = 3 * spot.segment;
    const auto n = curve.points.size();
    curve.points.set(first + 1, ladder.level(1)[0]);
    curve.points.set((first + 2) % n, ladder.level(1)[2]);
    const std::array added = {ladder.level(2)[0], ladder.tip(), ladder.level(2)[1]};
    for (std::size_t k = 0; k < added.size(); ++k) {
        curve.points.insert(first + 2 + k, added[k]);
    }
    return first + 3;
}

std::size_t lastAnchor(const Curve& curve) {
    return (curve.points.size() - 1) / 3 * 3;
}

void appendAnchor(Curve& curve, const Point& place) {
    const Point from = curve.points.at(lastAnchor(curve));
    if (curve.points.size() % 3 == 1) {
        curve.points.append(from + onward(curve, place - from));
    }
    if (curve.points.size() % 3 == 2) {
        curve.points.append(from + (2.0 / 3) * (place - from));
    }
    curve.points.append(place);
}

void deleteAnchorsAndHandles(Curve& curve, HandleModes& modes,
                             const std::set<std::size_t>& indices) {
    bool anchorsGo = false;
    for (const auto index : indices) {
        if (const auto anchor = anchorOf(curve, index)) {
            curve.points.set(index, curve.points.at(*anchor));
            loosen(modes, *anchor);
        }
        anchorsGo = anchorsGo || index % 3 == 0;
    }
    if (!anchorsGo) {
        return;
    }
    auto nodes = nodesOf(curve);
    std::vector<Node> kept;
    for (std::size_t k = 0; k < nodes.size(); ++k) {
        if (!indices.contains(3 * k)) {
            kept.push_back(std::move(nodes[k]));
        }
    }
    curve.points = pointsThrough(kept, curve);
    modes = renumbered(modes, [&](std::size_t anchor) -> std::optional<std::size_t> {
        const auto gone = std::ranges::count_if(
            indices, [&](std::size_t index) { return index % 3 == 0 && index < anchor; });
        return indices.contains(anchor)
                   ? std::nullopt
                   : std::optional(anchor - 3 * static_cast<std::size_t>(gone));
    });
}

void fitHandlesToClosing(Curve& curve, bool closed) {
    auto& points = curve.points;
    const auto n = points.size();
    if (closed && !curve.closed && n % 3 == 1 && n > 1) {
        const Point from = points.at(n - 1);
        const Point to = points.at(0);
        points.append(2.0 * from - points.at(n - 2));
        points.append(2.0 * to - points.at(1));
    } else if (!closed && curve.closed && n % 3 == 0) {
        points.erase(n - 1);
        points.erase(n - 2);
    }
}

} // namespace splineloft
