#include "ui/canvas/grid.h"

#include "ui/canvas/wording.h"

#include <algorithm>
#include <cmath>

namespace splineloft::ui {
namespace {

constexpr double finePixels = 16;
constexpr double coarsePixels = 80;

/// How many whole numbers there are from `first` on up to `last`; no more than a screen has pixels.
int linesBetween(double first, double last) {
    return static_cast<int>(std::clamp(std::floor(last - first) + 1, 0.0, 10'000.0));
}

/// Calls `use(k, x or y)` for every multiple k * step that lies within the frame, across or up.
template <class Use> void eachAcross(const Viewport& viewport, double step, Use use) {
    const auto& frame = viewport.frame;
    // Counted by whole steps: far out, a double k + 1 could be k again.
    const double first = std::ceil(viewport.toPlane({frame.left, 0}).x / step);
    const int count = linesBetween(first, viewport.toPlane({frame.right(), 0}).x / step);
    for (int i = 0; i < count; ++i) {
        use(first + i, viewport.toScreen({(first + i) * step, 0}).x);
    }
}
template <class Use> void eachUp(const Viewport& viewport, double step, Use use) {
    const auto& frame = viewport.frame;
    const double first = std::ceil(viewport.toPlane({0, frame.bottom()}).y / step);
    const int count = linesBetween(first, viewport.toPlane({0, frame.top}).y / step);
    for (int i = 0; i < count; ++i) {
        use(first + i, viewport.toScreen({0, (first + i) * step}).y);
    }
}

/// Both sets of parallel lines.
void drawLines(Scene& scene, const Viewport& viewport, double step, Role role) {
    const auto& frame = viewport.frame;
    const auto ink = [role](double k) { return Ink{k == 0 ? Role::gridAxis : role, 0}; };
    eachAcross(viewport, step, [&](double k, double x) {
        scene.strokes.push_back({{{x, frame.top}, {x, frame.bottom()}}, ink(k)});
    });
    eachUp(viewport, step, [&](double k, double y) {
        scene.strokes.push_back({{{frame.left, y}, {frame.right(), y}}, ink(k)});
    });
}

double coarseGridStep(const Camera& camera, double scale) {
    return gridStep(camera, coarsePixels * scale);
}

} // namespace

double fineGridStep(const Camera& camera, double scale) {
    return gridStep(camera, finePixels * scale);
}

void drawGrid(Scene& scene, const Viewport& viewport, double scale) {
    drawLines(scene, viewport, fineGridStep(viewport.camera, scale), Role::gridFine);
    drawLines(scene, viewport, coarseGridStep(viewport.camera, scale), Role::gridCoarse);
}

void drawGridNumbers(Scene& scene, const Viewport& viewport, double scale) {
    const auto& frame = viewport.frame;
    const double step = coarseGridStep(viewport.camera, scale);
    const double inset = 5 * scale;
    const auto number = [&](double k, ScreenPoint at) {
        scene.labels.push_back({decimal(k * step, step), at, 0, {Role::gridNumber}, true, true});
    };
    eachAcross(viewport, step,
               [&](double k, double x) { number(k, {x + inset, frame.bottom() - 10 * scale}); });
    eachUp(viewport, step, [&](double k, double y) {
        if (y < frame.bottom() - 30 * scale && y > frame.top + 14 * scale) {
            number(k, {frame.left + inset, y - 9 * scale});
        }
    });
}

} // namespace splineloft::ui
