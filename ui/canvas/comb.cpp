#include "ui/canvas/comb.h"

#include "ui/canvas/line_work.h"

#include <algorithm>
#include <cmath>

namespace splineloft::ui {
namespace {

constexpr std::size_t combTeeth = 150;  // on the whole curve, about
constexpr std::size_t mostCombed = 600; // pieces
constexpr double longestTooth = 90;     // design pixels
constexpr double usualTooth = 34;       // design pixels, for the mean curvature

} // namespace

void drawComb(Scene& scene, const Study& study, const Axes& axes, const Viewport& viewport,
              double scale) {
    const auto& plane = study.plane(axes);
    const int perPiece = static_cast<int>(
        std::clamp<std::size_t>(combTeeth / std::max<std::size_t>(plane.size(), 1), 6, 40));
    const auto [ranges, step] = samplingOf(study.inPlane(axes).boxes(), mostCombed, viewport);
    std::vector<Jet> jets;
    double sum = 0;
    for (const auto& range : ranges) {
        for (auto i = range.first; i < range.last; i += step) {
            for (int k = 0; k <= perPiece; ++k) {
                jets.push_back(plane.jet({i, static_cast<double>(k) / perPiece}));
                sum += std::abs(jets.back().curvature.value_or(0));
            }
        }
    }
    const double mean = jets.empty() ? 0 : sum / static_cast<double>(jets.size());
    std::vector<ScreenPoint> edge;
    for (const auto& jet : jets) {
        const ScreenPoint foot = viewport.toScreen({jet.position[0], jet.position[1]});
        const double speed = norm(jet.first);
        if (!(mean > 0) || !(speed > 0)) {
            edge.push_back(foot);
            continue;
        }
        const double tooth =
            scale * std::clamp(usualTooth * *jet.curvature / mean, -longestTooth, longestTooth);
        // To the outside of the bend; the screen's y points down.
        edge.push_back(
            {foot.x + tooth * jet.first[1] / speed, foot.y + tooth * jet.first[0] / speed});
        scene.strokes.push_back({{foot, edge.back()}, {Role::comb}});
    }
    if (!edge.empty()) {
        scene.strokes.push_back({std::move(edge), {Role::combEdge}});
    }
}

} // namespace splineloft::ui
