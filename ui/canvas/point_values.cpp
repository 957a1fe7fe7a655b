#include "ui/canvas/point_values.h"

#include "core/document/edits.h"
#include "ui/canvas/wording.h"

#include <array>

namespace splineloft::ui {
namespace {

/// A weight, described like a parameter.
constexpr Parameter weight{.key = "weight",
                           .label = "weight",
                           .symbol = "w",
                           .least = 1e-9,
                           .most = 1e9,
                           .sliderLeast = 0.05,
                           .sliderMost = 20,
                           .neutral = 1,
                           .scale = Scale::ratio,
                           .meaning = "How strongly the point pulls; at 1 as in a B-spline."};

} // namespace

std::vector<PointValue> pointValuesOf(const Curve& curve) {
    std::vector<PointValue> values;
    const Family& family = familyOf(curve);
    if (family.usesWeights) {
        values.push_back({weight, true});
    }
    for (const auto& parameter : family.parameters) {
        if (curve.local.contains(std::string(parameter.key))) {
            values.push_back({parameter, false});
        }
    }
    return values;
}

double valueAt(const Curve& curve, const PointValue& value, std::size_t point) {
    if (value.isWeight) {
        return curve.weights.empty() ? 1 : curve.weights.at(point);
    }
    return curve.local.at(std::string(value.parameter.key)).at(point);
}

Document withValueAt(const Document& document, std::size_t curve, const PointValue& value,
                     std::size_t point, double number) {
    return value.isWeight
               ? setWeight(document, curve, point, number)
               : setLocal(document, curve, value.parameter.key, std::array{point}, number);
}

std::string settingOf(const PointValue& value, std::size_t point) {
    return "Set " + std::string(value.parameter.label) + " of " + plainPointName(point);
}

} // namespace splineloft::ui
