// Numbers and names as people read them. The decimal point is a point in every locale.
#pragma once

#include <string>

namespace splineloft::ui {

/// `value` with as many decimals as a multiple of `step` needs; a true minus sign.
std::string decimal(double value, double step);

/// `value` with `digits` decimals and a true minus sign, never "-0".
std::string fixed(double value, int digits);

/// `value` with about `digits` significant digits, shortest of plain and scientific.
std::string significant(double value, int digits);

/// The text of a number with a true minus sign, and none before zero.
std::string withTrueMinus(std::string text);

/// The same with a plain "-", as number fields read it back.
std::string shortened(double value, int digits);

/// The shortest digits that read back as exactly `value`.
std::string exact(double value);

/// The name of control point `index` with its number lowered by "_": "P_3".
std::string pointName(std::size_t index);

/// The same in one string of Unicode, "P₃".
std::string plainPointName(std::size_t index);

} // namespace splineloft::ui
