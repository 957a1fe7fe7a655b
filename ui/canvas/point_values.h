// The numbers that a control point has besides its coordinates: a weight, and local parameters.
#pragma once

#include "core/document/document.h"

#include <span>
#include <string>
#include <vector>

namespace splineloft::ui {

/// One such number of a curve's points: the weight, or the parameter of that key. Its range, symbol
/// and meaning are those of the parameter.
struct PointValue {
    Parameter parameter;
    bool isWeight = false;
};

/// Those that the points of a curve have now: its weight where the family uses weights, and the
/// parameters that are local.
std::vector<PointValue> pointValuesOf(const Curve& curve);

double valueAt(const Curve& curve, const PointValue& value, std::size_t point);

/// The document with that number of one point changed.
Document withValueAt(const Document& document, std::size_t curve, const PointValue& value,
                     std::size_t point, double number);

/// "Set weight of P₃".
std::string settingOf(const PointValue& value, std::size_t point);

} // namespace splineloft::ui
