#include "ui/canvas/stems.h"

#include "ui/canvas/wording.h"
#include "ui/track.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace splineloft::ui {
namespace {

// Design pixels from the point.
constexpr double trackStart = 22;
constexpr double trackEnd = 104;
constexpr double knobReach = 9;

// The first stem leads down to the right, away from the point's name; the others follow clockwise.
constexpr double firstBearing = 0.25 * std::numbers::pi;
constexpr double nextBearing = 0.3 * std::numbers::pi;

ScreenPoint mixed(ScreenPoint a, ScreenPoint b, double part) {
    return {std::lerp(a.x, b.x, part), std::lerp(a.y, b.y, part)};
}

} // namespace

double Stem::numberAt(ScreenPoint at) const {
    const double dx = to.x - from.x;
    const double dy = to.y - from.y;
    const double along = ((at.x - from.x) * dx + (at.y - from.y) * dy) / (dx * dx + dy * dy);
    return valueOnTrack(value.parameter, along);
}

std::string Stem::words() const {
    return std::string(value.parameter.symbol) + " = " + significant(number, 4);
}

std::vector<Stem> stemsOf(const Document& document, const View& view, const Viewport& viewport,
                          double scale) {
    std::vector<Stem> stems;
    if (view.tool != Tool::select || view.selection.size() != 1) {
        return stems;
    }
    const PointId id = *view.selection.begin();
    if (id.part != Part::point || id.curve != view.activeCurve) {
        return stems;
    }
    const Curve& curve = *document.curves[id.curve];
    const ScreenPoint middle = viewport.toScreen(PointPlaces(document, view.axes)[id]);
    double angle = firstBearing;
    for (const auto& value : pointValuesOf(curve)) {
        const auto at = [&](double distance) {
            return ScreenPoint{middle.x + distance * scale * std::cos(angle),
                               middle.y + distance * scale * std::sin(angle)};
        };
        Stem stem{id, value, valueAt(curve, value, id.index), at(trackStart), at(trackEnd), {}};
        const double part = std::clamp(trackPosition(value.parameter, stem.number), 0.0, 1.0);
        stem.knob = mixed(stem.from, stem.to, part);
        stems.push_back(stem);
        angle += nextBearing;
    }
    return stems;
}

std::optional<Stem> stemAt(const std::vector<Stem>& stems, ScreenPoint at, double scale) {
    const auto found = std::ranges::find_if(stems, [&](const Stem& stem) {
        return std::hypot(stem.knob.x - at.x, stem.knob.y - at.y) <= knobReach * scale;
    });
    return found != stems.end() ? std::optional(*found) : std::nullopt;
}

} // namespace splineloft::ui
