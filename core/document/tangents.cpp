#include "core/document/tangents.h"

namespace splineloft {

Points catmullRomTangents(const Points& points, bool closed) {
    Points tangents(points.dimension());
    const auto n = points.size();
    for (std::size_t i = 0; i < n; ++i) {
        const auto before = i > 0 ? i - 1 : closed ? n - 1 : 0;
        const auto after = i + 1 < n ? i + 1 : closed ? 0 : i;
        tangents.append(0.5 * (points.at(after) - points.at(before)));
    }
    return tangents;
}

} // namespace splineloft
