#include "core/spline/change/corners.h"

namespace splineloft::conversion {

std::vector<Corner> cornersOf(const Shape& shape, Ends ends) {
    std::vector<Corner> corners(shape.joints());
    const auto last = corners.size() - 1;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        Corner& corner = corners[i];
        if (shape.closed || i > 0) {
            corner.before = shape.joint(i) - shape.joint((i + last) % (last + 1));
            corner.arriving = shape.arriving(i);
        }
        if (shape.closed || i < last) {
            corner.after = shape.joint((i + 1) % (last + 1)) - shape.joint(i);
            corner.leaving = shape.leaving(i);
        }
    }
    if (!shape.closed && ends != Ends::open) {
        const double factor = ends == Ends::reflected ? 1 : 0;
        corners.front().before = factor * *corners.front().after;
        corners.back().after = factor * *corners.back().before;
    }
    return corners;
}

std::vector<double> atPoints(std::vector<double> atJoints, const Curve& curve, double neutral) {
    if (curve.points.size() > atJoints.size()) {
        atJoints.insert(atJoints.begin(), neutral);
        atJoints.push_back(neutral);
    }
    return atJoints;
}

std::vector<Ends> waysToEnd(const Shape& shape) {
    return shape.closed ? std::vector{Ends::doubled}
                        : std::vector{Ends::doubled, Ends::reflected, Ends::open};
}

} // namespace splineloft::conversion
