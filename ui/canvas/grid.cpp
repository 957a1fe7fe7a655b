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

/// One set of parallel lines, across (x = k * step) or along (y = k * step).
void drawLines(Scene& scene, const Viewport& viewport, double step, Role role, double scale,
               bool numbered) {
    const auto& frame = viewport.frame;
    const PlanePoint low = viewport.toPlane({frame.left, frame.bottom()});
    const PlanePoint high = viewport.toPlane({frame.right(), frame.top});
    const auto ink = [role](double k) { return Ink{k == 0 ? Role::gridAxis : role, 0}; };
    const double inset = 5 * scale;
    // Counted by whole steps: far out, a double k + 1 could be k again.
    const double left = std::ceil(low.x / step);
    for (int i = 0; i < linesBetween(left, high.x / step); ++i) {
        const double k = left + i;
        const double x = viewport.toScreen({k * step, 0}).x;
        scene.strokes.push_back({{{x, frame.top}, {x, frame.bottom()}}, ink(k)});
        if (numbered) {
            scene.labels.push_back({decimal(k * step, step),
                                    {x + inset, frame.bottom() - 10 * scale},
                                    0,
                                    {Role::gridNumber},
                                    true,
                                    true});
        }
    }
    const double lowest = std::ceil(low.y / step);
    for (int i = 0; i < linesBetween(lowest, high.y / step); ++i) {
        const double k = lowest + i;
        const double y = viewport.toScreen({0, k * step}).y;
        scene.strokes.push_back({{{frame.left, y}, {frame.right(), y}}, ink(k)});
        const bool clear = y < frame.bottom() - 30 * scale && y > frame.top + 14 * scale;
        if (numbered && clear) {
            scene.labels.push_back({decimal(k * step, step),
                                    {frame.left + inset, y - 9 * scale},
                                    0,
                                    {Role::gridNumber},
                                    true,
                                    true});
        }
    }
}

} // namespace

double fineGridStep(const Camera& camera, double scale) {
    return gridStep(camera, finePixels * scale);
}

void drawGrid(Scene& scene, const Viewport& viewport, double scale) {
    const double fine = fineGridStep(viewport.camera, scale);
    const double coarse = gridStep(viewport.camera, coarsePixels * scale);
    drawLines(scene, viewport, fine, Role::gridFine, scale, false);
    drawLines(scene, viewport, coarse, Role::gridCoarse, scale, true);
}

} // namespace splineloft::ui
