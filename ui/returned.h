// What a step through the history has brought back.
#pragma once

#include "core/document/document.h"

#include <optional>
#include <vector>

namespace splineloft::ui {

/// Control points and a curve that one document has more than another.
struct Returned {
    std::vector<PointId> points;      ///< of Bézier splines the anchors, where there are any
    std::optional<std::size_t> curve; ///< the last that is there again, with all its points
};

/// What `after` has more than `before`, where all else has stayed: nothing of a curve whose other
/// points have moved as well, or beside curves that have changed.
Returned returned(const Document& before, const Document& after);

} // namespace splineloft::ui
