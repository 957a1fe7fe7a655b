#include "core/document/handle_modes.h"

#include "core/document/change.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace splineloft {
namespace {

// Handles are in line up to this part of a radian squared, and of one length up to this part of it.
constexpr double enough = 1e-9;
// Places are kept to 14 digits.
constexpr double placeRounding = 1e-13;

/// An anchor and the way from it to the handle that arrives and to the one that leaves.
struct Arms {
    std::size_t arriving, leaving; ///< numbers of the handles
    Point back, forth;
    double rounding; ///< of lengths
};

/// The arms of an anchor that has both.
std::optional<Arms> armsOf(const Curve& curve, std::size_t anchor) {
    const auto handles = handlesOf(curve, anchor);
    if (handles.size() != 2) {
        return std::nullopt;
    }
    const auto leaving = anchor + 1;
    const auto arriving = *handles.begin() == leaving ? *handles.rbegin() : *handles.begin();
    const Point at = curve.points.at(anchor);
    const auto sizes = at.coordinates();
    const double size = std::abs(*std::ranges::max_element(
        sizes, {}, [](double coordinate) { return std::abs(coordinate); }));
    return Arms{arriving, leaving, curve.points.at(arriving) - at, curve.points.at(leaving) - at,
                placeRounding * size};
}

bool inLine(const Arms& arms) {
    const double a = norm(arms.back);
    const double b = norm(arms.forth);
    if (a == 0 || b == 0) {
        return false;
    }
    const double angle = arms.rounding / a + arms.rounding / b;
    return -dot(arms.back, arms.forth) >= a * b * (1 - enough - angle * angle);
}

bool equallyLong(const Arms& arms) {
    const double a = norm(arms.back);
    const double b = norm(arms.forth);
    return std::abs(a - b) <= enough * (a + b) + arms.rounding;
}

HandleMode modeOf(const Curve& curve, const HandleModes& modes, std::size_t anchor) {
    const auto stored = modes.find(anchor);
    return stored == modes.end() ? shownMode(curve, anchor) : stored->second;
}

/// Puts both handles on one line, at these distances from their anchor.
void layInLine(Curve& curve, std::size_t anchor, const Arms& arms, double back, double forth) {
    const Point mean = unitVector(arms.forth) - unitVector(arms.back);
    // Where both go the same way, there is no mean; the one that leaves stays.
    const Point direction = norm(mean) > 0 ? unitVector(mean) : unitVector(arms.forth);
    const Point at = curve.points.at(anchor);
    curve.points.set(arms.arriving, at - back * direction);
    curve.points.set(arms.leaving, at + forth * direction);
}

/// Makes the mode hold; automatic handles find their places when the modes are settled.
void obey(Curve& curve, std::size_t anchor, HandleMode mode) {
    const auto arms = armsOf(curve, anchor);
    if (!arms || mode == HandleMode::corner || mode == HandleMode::automatic) {
        return;
    }
    const double back = norm(arms->back);
    const double forth = norm(arms->forth);
    const double mean = 0.5 * (back + forth);
    if (mode == HandleMode::mirrored && !(inLine(*arms) && equallyLong(*arms))) {
        layInLine(curve, anchor, *arms, mean, mean);
    } else if (mode == HandleMode::aligned && !inLine(*arms)) {
        layInLine(curve, anchor, *arms, back, forth);
    }
}

void keepPartner(const Curve& before, Curve& after, std::size_t handle, HandleMode mode) {
    const auto anchor = anchorOf(before, handle);
    const auto partner = partnerOf(before, handle);
    if (mode == HandleMode::corner || !anchor || !partner) {
        return;
    }
    const Point at = after.points.at(*anchor);
    const Point away = at - after.points.at(handle);
    if (norm(away) > 0) {
        const double reach =
            mode == HandleMode::mirrored ? norm(away) : distance(before.points.at(*partner), at);
        after.points.set(*partner, at + (reach / norm(away)) * away);
    }
}

/// The derivative by length, at `at`, of the parabola through three points spaced by their
/// distances: never longer than 1, and nothing where the way turns back.
Point slopeBetween(const Point& before, const Point& at, const Point& after) {
    const double a = distance(before, at);
    const double b = distance(at, after);
    if (a == 0 || b == 0) {
        return Point(at.dimension());
    }
    return (b / (a + b) / a) * (at - before) + (a / (a + b) / b) * (after - at);
}

/// Handles of an anchor between two others: on the tangent of the parabola through the three, a
/// third of the way to the neighbours.
void placeBetween(Curve& curve, std::size_t anchor, std::size_t before, std::size_t after) {
    const auto arms = armsOf(curve, anchor);
    if (!arms) {
        return;
    }
    const Point at = curve.points.at(anchor);
    const Point from = curve.points.at(before);
    const Point to = curve.points.at(after);
    const Point slope = slopeBetween(from, at, to);
    curve.points.set(arms->arriving, at - (distance(from, at) / 3) * slope);
    curve.points.set(arms->leaving, at + (distance(at, to) / 3) * slope);
}

/// The handle of an anchor at an end: half of the way to the handle on the other side of its piece,
/// so that the curve begins without curvature; a single piece is straight.
void placeAtEnd(Curve& curve, std::size_t anchor, std::size_t neighbour, bool neighbourFollows) {
    const bool isStart = neighbour > anchor;
    const auto own = isStart ? anchor + 1 : anchor - 1;
    const auto facing = isStart ? neighbour - 1 : neighbour + 1;
    const Point at = curve.points.at(anchor);
    const bool single = handlesOf(curve, neighbour).size() == 1 && neighbourFollows;
    const Point aim =
        single ? lerp(at, curve.points.at(neighbour), 2.0 / 3) : curve.points.at(facing);
    curve.points.set(own, lerp(at, aim, 0.5));
}

void placeAutomatic(Curve& curve, const HandleModes& modes) {
    for (const bool atEnds : {false, true}) { // ends look at their neighbours' handles
        for (const auto& [anchor, mode] : modes) {
            if (mode != HandleMode::automatic) {
                continue;
            }
            const auto before = anchorBefore(curve, anchor);
            const auto after = anchorAfter(curve, anchor);
            const auto only = before ? before : after;
            if (before && after && !atEnds) {
                placeBetween(curve, anchor, *before, *after);
            } else if (atEnds && only && !(before && after)) {
                placeAtEnd(curve, anchor, *only,
                           modeOf(curve, modes, *only) == HandleMode::automatic);
            }
        }
    }
}

} // namespace

HandleMode shownMode(const Curve& curve, std::size_t anchor) {
    const auto arms = armsOf(curve, anchor);
    if (!arms || !inLine(*arms)) {
        return HandleMode::corner;
    }
    return equallyLong(*arms) ? HandleMode::mirrored : HandleMode::aligned;
}

void keepPartners(const Curve& before, Curve& after, HandleModes& modes,
                  const std::set<std::size_t>& moved) {
    if (!hasHandles(before)) {
        return;
    }
    for (const auto index : moved) {
        const auto anchor = anchorOf(before, index);
        if (!anchor || moved.contains(*anchor)) {
            continue;
        }
        const auto mode = modeOf(before, modes, *anchor);
        const auto partner = partnerOf(before, index);
        if (!partner || !moved.contains(*partner)) {
            keepPartner(before, after, index, mode);
        }
        if (mode == HandleMode::automatic) {
            modes[*anchor] = HandleMode::aligned;
        }
    }
}

void settleModes(Curve& curve, HandleModes& modes) {
    if (modes.empty()) {
        return;
    }
    if (!hasHandles(curve)) {
        modes.clear();
        return;
    }
    std::erase_if(modes, [&](const auto& entry) {
        return entry.first % 3 != 0 || entry.first >= curve.points.size();
    });
    placeAutomatic(curve, modes);
    std::erase_if(modes, [&](const auto& entry) {
        const auto& [anchor, mode] = entry;
        return mode != HandleMode::automatic &&
               (handlesOf(curve, anchor).size() < 2 || mode == shownMode(curve, anchor));
    });
}

void loosen(HandleModes& modes, std::size_t anchor) {
    const auto stored = modes.find(anchor);
    if (stored != modes.end() && stored->second != HandleMode::corner) {
        modes.erase(stored);
    }
}

bool makeRoomForMode(const Curve& curve, HandleModes& modes, std::size_t anchor) {
    modes = renumbered(
        modes, [&](std::size_t old) { return std::optional(old < anchor ? old : old + 3); });
    const auto isAutomatic = [&](std::optional<std::size_t> neighbour) {
        return neighbour && modeOf(curve, modes, *neighbour) == HandleMode::automatic;
    };
    const bool before = isAutomatic(anchorBefore(curve, anchor));
    const bool after = isAutomatic(anchorAfter(curve, anchor));
    if (before && after) {
        modes[anchor] = HandleMode::automatic;
    }
    return before || after;
}

void continueMode(HandleModes& modes, std::size_t last, std::size_t added) {
    const auto stored = modes.find(last);
    if (stored != modes.end() && stored->second == HandleMode::automatic) {
        modes[added] = HandleMode::automatic;
    }
}

HandleMode modeOf(const CurveEntry& entry, std::size_t anchor) {
    return modeOf(*entry, entry.handleModes, anchor);
}

Document setHandleMode(const Document& document, std::span<const PointId> ids, HandleMode mode) {
    std::map<std::size_t, std::set<std::size_t>> anchors; // by curve
    for (const auto& id : ids) {
        const Curve& curve = *document.curves[id.curve];
        if (id.part == Part::point && hasHandles(curve)) {
            anchors[id.curve].insert(anchorOf(curve, id.index).value_or(id.index));
        }
    }
    Document next = document;
    for (const auto& [index, ofCurve] : anchors) {
        next = changed(next, index, [&own = ofCurve, mode](Curve& curve, HandleModes& modes) {
            for (const auto anchor : own) {
                obey(curve, anchor, mode);
                modes[anchor] = mode;
            }
        });
    }
    return next;
}

HandleMode nextHandleMode(HandleMode mode) {
    switch (mode) {
    case HandleMode::corner: return HandleMode::aligned;
    case HandleMode::aligned: return HandleMode::mirrored;
    case HandleMode::mirrored: return HandleMode::automatic;
    case HandleMode::automatic: return HandleMode::corner;
    }
    return HandleMode::corner;
}

std::string_view nameOf(HandleMode mode) {
    switch (mode) {
    case HandleMode::corner: return "corner";
    case HandleMode::aligned: return "aligned";
    case HandleMode::mirrored: return "mirrored";
    case HandleMode::automatic: return "automatic";
    }
    return "";
}

} // namespace splineloft
