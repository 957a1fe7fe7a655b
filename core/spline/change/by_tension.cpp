// Cardinal: the control points are the joints, and each tangent is a multiple of the chord between
// the neighbours, everywhere the same one or at each point its own.
#include "core/spline/catalog.h"
#include "core/spline/change/corners.h"
#include "core/spline/change/fit.h"
#include "core/spline/change/proposers.h"

namespace splineloft::conversion {
namespace {

/// What the tangents at a corner say about the tension.
void appendRows(std::vector<Row>& rows, const Corner& corner) {
    if (corner.before && corner.after) {
        const Point chord = *corner.before + *corner.after;
        for (const auto& tangent : {corner.arriving, corner.leaving}) {
            if (tangent) {
                rows.push_back({chord, Point(chord.dimension()), *tangent});
            }
        }
    }
}

Curve cardinalWith(const Shape& shape, const Trial& trial, Ends ends,
                   const std::vector<double>& tensions) {
    return throughJoints(shape, trial, ends, [&](std::size_t end) {
        const double a = tensions[end];
        const double factor = a != 0 ? (end == 0 ? -1 : 1) / a : 0;
        const Point inward = shape.joint(end == 0 ? 1 : end - 1);
        return a != 0 ? inward + factor * shape.leaving(end) : shape.joint(end);
    });
}

} // namespace

void proposeCardinal(const Shape& shape, Trial& trial) {
    const Curve blank = trial.blank();
    const double neutral = parameterOf(blank, "tension");
    for (const Ends ends : waysToEnd(shape)) {
        std::vector<Row> rows;
        for (const auto& corner : cornersOf(shape, ends)) {
            appendRows(rows, corner);
        }
        const double measured = fitOne(rows, shape.tolerance).value_or(neutral);
        const double tension = tidied(measured, blank, "tension");
        Curve curve =
            cardinalWith(shape, trial, ends, std::vector<double>(shape.joints(), tension));
        curve.parameters["tension"] = tension;
        if (trial.offer(curve)) {
            return;
        }
    }
    for (const Ends ends : waysToEnd(shape)) {
        std::vector<double> tensions;
        for (const auto& corner : cornersOf(shape, ends)) {
            std::vector<Row> rows;
            appendRows(rows, corner);
            const double measured = fitOne(rows, shape.tolerance).value_or(neutral);
            tensions.push_back(tidied(measured, blank, "tension"));
        }
        Curve curve = cardinalWith(shape, trial, ends, tensions);
        curve.local["tension"] = atPoints(tensions, curve, neutral);
        if (trial.offer(curve)) {
            return;
        }
    }
}

} // namespace splineloft::conversion
