#include "ui/canvas/gizmo.h"

#include "ui/canvas/wording.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace splineloft::ui {
namespace {

// Design pixels.
constexpr double gizmoMargin = 18; // between the outermost points and the frame
constexpr double ringAbove = 26;   // the frame
constexpr double gripReach = 9;

double degreesOf(double radians) {
    return radians * 180 / std::numbers::pi;
}

/// A turn, by what is left of it after whole multiples of `step` degrees are taken.
double inSteps(double angle, double step) {
    const double radians = step * std::numbers::pi / 180;
    return std::round(angle / radians) * radians;
}

/// The angle from the middle at which a place is seen.
double bearing(PlanePoint middle, PlanePoint place) {
    return std::atan2(place.y - middle.y, place.x - middle.x);
}

Transform turned(const PlaneBox& box, const Pull& pull) {
    const PlanePoint middle = box.middle();
    double angle =
        std::remainder(bearing(middle, pull.to) - bearing(middle, pull.from), 2 * std::numbers::pi);
    if (pull.evenly || pull.byFifteen) {
        angle = inSteps(angle, pull.evenly ? 45 : 15);
    }
    return {PlaneMap::rotatedAbout({middle.x, middle.y}, angle),
            decimal(degreesOf(angle), 0.1) + "°"};
}

/// Where the ring of a frame is: above it, else below it, else at the canvas's upper edge.
ScreenPoint ringOf(const ScreenRect& frame, const ScreenRect& canvas, double scale) {
    const double edge = ringAbove / 2 * scale;
    const double above = frame.top - ringAbove * scale;
    const double below = frame.bottom() + ringAbove * scale;
    const auto inView = [&](double y) {
        return y >= canvas.top + edge && y <= canvas.bottom() - edge;
    };
    const double left = canvas.left + edge;
    const double right = std::max(canvas.right() - edge, left);
    const double y = inView(above) ? above : inView(below) ? below : canvas.top + edge;
    return {std::clamp(frame.left + frame.width / 2, left, right), y};
}

/// One axis of a scaling: the side that is pulled, and the one that stays.
struct Reach {
    double side = 0, still = 0;
    double factor(double to) const { return side == still ? 1 : (to - still) / (side - still); }
};

Reach reachOf(double low, double high, int at, bool aboutMiddle) {
    const double side = at > 0 ? high : low;
    const double opposite = at > 0 ? low : high;
    return {at == 0 ? low : side, at == 0 || aboutMiddle ? 0.5 * (low + high) : opposite};
}

std::string percent(double factor) {
    return decimal(100 * factor, 0.1) + " %";
}

Transform scaled(const PlaneBox& box, const Pull& pull) {
    const auto& grip = pull.grip;
    const Reach across = reachOf(box.low.x, box.high.x, grip.across, pull.aboutMiddle);
    const Reach up = reachOf(box.low.y, box.high.y, grip.up, pull.aboutMiddle);
    const auto to = [&](double side, double moved) {
        return pull.snap > 0 ? roundedTo(side + moved, pull.snap) : side + moved;
    };
    double byX = grip.across == 0 ? 1 : across.factor(to(across.side, pull.to.x - pull.from.x));
    double byY = grip.up == 0 ? 1 : up.factor(to(up.side, pull.to.y - pull.from.y));
    if (pull.evenly) {
        // Where both axes are pulled, as far as the pull goes along the diagonal.
        const double w = grip.across == 0 ? 0 : across.side - across.still;
        const double h = grip.up == 0 ? 0 : up.side - up.still;
        byX = byY = (byX * w * w + byY * h * h) / (w * w + h * h);
    }
    return {PlaneMap::scaledAbout({across.still, up.still}, byX, byY),
            byX == byY ? percent(byX) : percent(byX) + " × " + percent(byY)};
}

} // namespace

std::optional<PlaneBox> boxOfSelection(const Document& document, const View& view) {
    std::optional<PlaneBox> box;
    PointPlaces places(document, view.axes);
    for (const auto& id : view.selection) {
        if (id.part == Part::point) {
            const PlanePoint p = places[id];
            box = !box ? PlaneBox{p, p}
                       : PlaneBox{{std::min(box->low.x, p.x), std::min(box->low.y, p.y)},
                                  {std::max(box->high.x, p.x), std::max(box->high.y, p.y)}};
        }
    }
    return box && !(box->low == box->high) ? box : std::nullopt;
}

ScreenPoint Gizmo::placeOf(const Grip& grip) const {
    if (grip.turns()) {
        return ring;
    }
    return {frame.left + 0.5 * (1 + grip.across) * frame.width,
            frame.top + 0.5 * (1 - grip.up) * frame.height};
}

std::vector<Grip> Gizmo::grips() const {
    std::vector<Grip> all;
    for (const int across : {-1, 0, 1}) {
        for (const int up : {-1, 0, 1}) {
            const bool flat = (across != 0 && box.width() == 0) || (up != 0 && box.height() == 0);
            if (!flat) {
                all.push_back({across, up});
            }
        }
    }
    return all;
}

Gizmo gizmoAround(const PlaneBox& box, const Viewport& viewport, double scale) {
    const ScreenPoint a = viewport.toScreen({box.low.x, box.high.y});
    const ScreenPoint b = viewport.toScreen({box.high.x, box.low.y});
    const double m = gizmoMargin * scale;
    const ScreenRect frame{a.x - m, a.y - m, b.x - a.x + 2 * m, b.y - a.y + 2 * m};
    return {box, frame, ringOf(frame, viewport.frame, scale)};
}

std::optional<Gizmo> gizmoOf(const Document& document, const View& view, const Viewport& viewport,
                             double scale) {
    if (view.tool != Tool::select || view.selection.size() < 2) {
        return std::nullopt;
    }
    const auto box = boxOfSelection(document, view);
    if (!box) {
        return std::nullopt;
    }
    return gizmoAround(*box, viewport, scale);
}

std::optional<Grip> gripAt(const Gizmo& gizmo, ScreenPoint at, double scale) {
    for (const auto& grip : gizmo.grips()) {
        const ScreenPoint place = gizmo.placeOf(grip);
        if (std::hypot(place.x - at.x, place.y - at.y) <= gripReach * scale) {
            return grip;
        }
    }
    return std::nullopt;
}

Transform transformOf(const PlaneBox& box, const Pull& pull) {
    return pull.grip.turns() ? turned(box, pull) : scaled(box, pull);
}

} // namespace splineloft::ui
