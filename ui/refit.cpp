#include "ui/refit.h"

#include "ui/canvas/viewport.h"

#include <algorithm>

namespace splineloft::ui {
namespace {

constexpr double usualUnit = 80;                 // design pixels, where there is nothing to fit
constexpr double fitMargin = 72;                 // design pixels around what is fitted
constexpr std::size_t mostPiecesLooked = 10'000; // more of them bulge nowhere far

/// A box that grows around points.
struct Bounds {
    std::optional<PlanePoint> low;
    PlanePoint high;

    void include(PlanePoint p) {
        high = low ? PlanePoint{std::max(high.x, p.x), std::max(high.y, p.y)} : p;
        low = low ? PlanePoint{std::min(low->x, p.x), std::min(low->y, p.y)} : p;
    }

    void include(const Study& study, const Axes& axes) {
        for (const auto& place : controlPlaces(study.curve(), axes)) {
            include(place);
        }
        const CurvePlaces tips(study.curve(), axes);
        for (std::size_t k = 0; k < study.curve().tangents.size(); ++k) {
            include(tips.tangentTip(k));
        }
        const auto& plane = study.plane(axes);
        for (std::size_t k = 0; k < std::min(plane.size(), mostPiecesLooked); ++k) {
            for (const double u : {0.25, 0.5, 0.75}) {
                const Point p = plane.position({k, u});
                include({p[0], p[1]});
            }
        }
    }
};

} // namespace

void followScreen(Session& session, double scale, const ScreenRect& canvas) {
    const ScreenRect before = session.canvas;
    auto& unit = session.view.camera.pixelsPerUnit;
    if (!session.view.presenting) {
        unit *= scale / session.scale;
    } else if (before.width > 0 && before.height > 0) {
        unit *= std::min(canvas.width / before.width, canvas.height / before.height);
    }
    session.scale = scale;
    session.canvas = canvas;
}

void fitIfAsked(Session& session) {
    auto& view = session.view;
    if (!view.fitPending || session.canvas.width <= 0) {
        return;
    }
    view.fitPending = false;
    Bounds bounds;
    const auto& curves = session.document().curves;
    for (std::size_t i = 0; i < session.studies.size(); ++i) {
        if (curves[i].look.visible) {
            bounds.include(session.studies[i], view.axes);
        }
    }
    const auto& [low, high] = bounds;
    view.camera = low && !(*low == high)
                      ? fitted(*low, high, session.canvas, fitMargin * session.scale)
                      : Camera{low.value_or(PlanePoint{}), usualUnit * session.scale};
}

} // namespace splineloft::ui
