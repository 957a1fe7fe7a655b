#include "ui/refit.h"

#include "ui/canvas/viewport.h"

#include <algorithm>

namespace splineloft::ui {
namespace {

constexpr double usualUnit = 80;                 // design pixels, where there is nothing to fit
constexpr double fitMargin = 72;                 // design pixels around what is fitted, ...
constexpr double mostMargin = 0.15;              // ... but no more of the canvas' shorter side
constexpr std::size_t mostPiecesLooked = 10'000; // more of them bulge nowhere far

/// The box around all of a curve, what bulges beyond its points included.
PlaneBounds boundsOf(const PlaneStudy& study) {
    PlaneBounds box = study.points().boxes().whole();
    box.include(study.tips().boxes().whole());
    const auto& plane = study.pieces();
    for (std::size_t k = 0; k < std::min(plane.size(), mostPiecesLooked); ++k) {
        for (const double u : {0.25, 0.5, 0.75}) {
            const Point p = plane.position({k, u});
            box.include(PlanePoint{p[0], p[1]});
        }
    }
    return box;
}

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
    PlaneBounds box;
    const auto& curves = session.document().curves;
    for (std::size_t i = 0; i < session.studies.size(); ++i) {
        if (curves[i].look.visible) {
            box.include(boundsOf(session.studies[i].inPlane(view.axes)));
        }
    }
    const double margin =
        std::min(fitMargin * session.scale,
                 mostMargin * std::min(session.canvas.width, session.canvas.height));
    const PlanePoint low{box.left, box.bottom};
    const PlanePoint high{box.right, box.top};
    view.camera = !box.empty() && !(low == high)
                      ? fitted(low, high, session.canvas, margin)
                      : Camera{box.empty() ? PlanePoint{} : low, usualUnit * session.scale};
}

} // namespace splineloft::ui
