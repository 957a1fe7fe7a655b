// Families whose points and tangents lie on the pieces: they are read off.
#include "core/spline/catalog.h"
#include "core/spline/change/proposers.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace splineloft::conversion {
namespace {

// Values of parameters within this of an end of their range belong to it.
constexpr double nearRange = 1e-9;
// Values within this of a simple fraction are that fraction: less than the tolerance of a curve.
constexpr double nearFraction = 2e-13;

} // namespace

double tidied(double value, const Spline& spline, std::string_view key) {
    const auto& parameters = familyOf(spline).parameters;
    const auto& range = *std::ranges::find(parameters, key, &Parameter::key);
    for (const double denominator : {720.0, 1000.0}) { // of most small fractions, and of decimals
        const double fraction = std::round(value * denominator) / denominator;
        if (std::abs(value - fraction) <= nearFraction * std::max(1.0, std::abs(value))) {
            value = fraction + 0.0; // never -0
            break;
        }
    }
    const bool near = value > range.least - nearRange && value < range.most + nearRange;
    return near ? std::clamp(value, range.least, range.most) : value;
}

void proposeBezierSpline(const Shape& shape, Trial& trial) {
    Curve curve = trial.blank();
    for (std::size_t i = 0; i < shape.size(); ++i) {
        for (int k = 0; k < 3; ++k) {
            curve.points.append(shape.pieces[i].bezierPoint(k));
        }
    }
    if (!shape.closed) {
        curve.points.append(shape.joint(shape.size()));
    }
    trial.offer(curve);
}

void proposeHermite(const Shape& shape, Trial& trial) {
    Curve curve = trial.blank();
    for (std::size_t i = 0; i < shape.joints(); ++i) {
        curve.points.append(shape.joint(i));
        curve.tangents.append(shape.leaving(i));
    }
    trial.offer(curve);
}

void proposeBezier(const Shape& shape, Trial& trial) {
    Curve curve = trial.blank();
    for (int k = 0; k <= shape.pieces.degree(); ++k) {
        curve.points.append(shape.pieces[0].bezierPoint(k));
    }
    trial.offer(curve);
}

void proposeLinear(const Shape& shape, Trial& trial) {
    Curve curve = trial.blank();
    for (std::size_t i = 0; i < shape.joints(); ++i) {
        curve.points.append(shape.joint(i));
    }
    trial.offer(curve);
}

void proposeParametricParabola(const Shape& shape, Trial& trial) {
    Curve curve = trial.blank();
    const double mu = parameterOf(curve, "mu");
    for (std::size_t i = 0; i < shape.size(); ++i) {
        curve.points.append(shape.joint(i));
        curve.points.append(shape.pieces.position({i, mu}));
    }
    if (!shape.closed) {
        curve.points.append(shape.joint(shape.size()));
    }
    trial.offer(curve);
}

void proposeLagrange(const Shape& shape, Trial& trial) {
    Curve curve = trial.blank();
    const int degree = shape.pieces.degree();
    for (int k = 0; k <= degree; ++k) {
        curve.points.append(shape.pieces.position({0, static_cast<double>(k) / degree}));
    }
    trial.offer(curve);
}

} // namespace splineloft::conversion
