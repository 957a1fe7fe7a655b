#include "ui/canvas/thumbnail.h"

#include "core/spline/curve.h"
#include "core/spline/measure/bounds.h"
#include "ui/canvas/outline.h"

#include <algorithm>

namespace splineloft::ui {
namespace {

constexpr double thumbnailMargin = 8; // design pixels
// On a stamp more pieces than this fall together; a place on each so many is enough.
constexpr std::size_t mostPieces = 1000;

std::vector<ScreenPoint> lineOf(const Pieces& plane, const Viewport& viewport) {
    if (plane.size() <= mostPieces) {
        return outline(plane, viewport);
    }
    std::vector<ScreenPoint> line;
    for (std::size_t i = 0; i <= mostPieces; ++i) {
        const std::size_t at = i * (plane.size() - 1) / mostPieces;
        const Point p = plane.position({at, i == mostPieces ? 1.0 : 0.0});
        line.push_back(viewport.toScreen({p[0], p[1]}));
    }
    return line;
}

} // namespace

Thumbnail thumbnailOf(const Document& document) {
    std::vector<Pieces> planes;
    std::optional<Box> whole;
    for (const auto& entry : document.curves) {
        planes.push_back(flattened(piecesOf(*entry), {}));
        if (const auto box = hullBox(planes.back())) {
            whole = whole.value_or(*box);
            for (int i = 0; i < 2; ++i) {
                whole->low[i] = std::min(whole->low[i], box->low[i]);
                whole->high[i] = std::max(whole->high[i], box->high[i]);
            }
        }
    }
    Thumbnail lines;
    if (!whole) {
        return lines;
    }
    const ScreenRect frame{0, 0, thumbnailWidth, thumbnailHeight};
    const Viewport viewport{fitted({whole->low[0], whole->low[1]}, {whole->high[0], whole->high[1]},
                                   frame, thumbnailMargin),
                            frame};
    for (const auto& plane : planes) {
        if (!plane.empty()) {
            lines.push_back(lineOf(plane, viewport));
        }
    }
    return lines;
}

} // namespace splineloft::ui
