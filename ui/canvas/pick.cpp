#include "ui/canvas/pick.h"

#include <cmath>

namespace splineloft::ui {
namespace {

/// Whether a mark is drawn above that of another point: points above tangents, and in order.
bool isAbove(const PointId& id, const PointId& other) {
    return id.part != other.part ? id.part == Part::point : id > other;
}

/// The best candidate so far: the lower score wins, and among equals the one that is seen.
struct Best {
    std::optional<PointId> point;
    double score = 0;

    void offer(const PointId& id, double distance, bool selected, bool active) {
        // Preference counts like nearness: a selected point wins over one that is 6 pixels nearer.
        const double offered = distance - (selected ? 6 : 0) - (active ? 3 : 0);
        constexpr double equal = 1e-6;
        if (!point || offered < score - equal || (offered <= score && isAbove(id, *point))) {
            point = id;
            score = offered;
        }
    }
};

double screenDistance(ScreenPoint a, ScreenPoint b) {
    return std::hypot(a.x - b.x, a.y - b.y);
}

/// Calls visit(point, distance in design pixels) for all points and tangents within reach.
template <class Visit>
void eachUnder(const Document& document, const Studies& studies, const View& view,
               const Viewport& viewport, ScreenPoint at, double scale, Visit visit) {
    const PlaneBounds near = around(viewport.toPlane(at), viewport.toPlane(pointReach * scale));
    for (std::size_t c = 0; c < studies.size(); ++c) {
        if (!document.curves[c].look.isTouchable()) {
            continue;
        }
        const auto offer = [&](const PointId& id, PlanePoint place) {
            const double away = screenDistance(viewport.toScreen(place), at);
            if (away <= pointReach * scale) {
                visit(id, away / scale);
            }
        };
        const PlaneStudy& plane = studies[c].inPlane(view.axes);
        plane.points().forEachNear(
            near, [&](std::size_t i, PlanePoint place) { offer({c, i, Part::point}, place); });
        if (c == view.activeCurve) {
            plane.tips().forEachNear(near, [&](std::size_t i, PlanePoint place) {
                offer({c, i, Part::tangent}, place);
            });
        }
    }
}

std::optional<CurveHit> pickCurve(const Document& document, const Studies& studies,
                                  const View& view, const Viewport& viewport, ScreenPoint at,
                                  double reach) {
    const PlanePoint place = viewport.toPlane(at);
    std::optional<CurveHit> hit;
    double best = viewport.toPlane(reach);
    for (std::size_t i = 0; i < studies.size(); ++i) {
        if (!document.curves[i].look.isTouchable()) {
            continue;
        }
        const auto nearest = nearestTo(studies[i].inPlane(view.axes), place, best);
        if (nearest) {
            hit = {i, nearest->spot};
            // The active curve is not lost to another that crosses it.
            best = i == view.activeCurve ? nearest->distance / 2 : nearest->distance;
        }
    }
    return hit;
}

} // namespace

Hit pick(const Document& document, const Studies& studies, const View& view,
         const Viewport& viewport, ScreenPoint at, double scale) {
    Best best;
    eachUnder(document, studies, view, viewport, at, scale, [&](const PointId& id, double away) {
        best.offer(id, away, view.selection.contains(id), id.curve == view.activeCurve);
    });
    if (best.point) {
        return {best.point, std::nullopt};
    }
    return {std::nullopt, pickCurve(document, studies, view, viewport, at, curveReach * scale)};
}

std::vector<PointId> pointsUnder(const Document& document, const Studies& studies, const View& view,
                                 const Viewport& viewport, ScreenPoint at, double scale) {
    std::vector<PointId> under;
    eachUnder(document, studies, view, viewport, at, scale,
              [&](const PointId& id, double) { under.push_back(id); });
    return under;
}

Selection pointsInside(const Document& document, const Studies& studies, const View& view,
                       const Viewport& viewport, const ScreenRect& rect) {
    std::vector<PointId> inside;
    for (std::size_t c = 0; c < studies.size(); ++c) {
        if (!document.curves[c].look.isTouchable()) {
            continue;
        }
        studies[c].inPlane(view.axes).points().forEachNear(
            viewport.boxUnder(rect), [&](std::size_t i, PlanePoint place) {
                if (rect.contains(viewport.toScreen(place))) {
                    inside.push_back({c, i, Part::point});
                }
            });
    }
    return Selection(std::move(inside));
}

} // namespace splineloft::ui
