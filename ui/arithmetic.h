// Numbers as people type them into a field: "3+0.1", "-2*(1/3)", with a minus sign of either kind.
#pragma once

#include <optional>
#include <string_view>

namespace splineloft::ui {

/// The value of an expression of numbers, + - * / and parentheses; nothing where it is not one or
/// its value is not finite. The decimal sign is a point in every locale.
std::optional<double> valueOf(std::string_view expression);

} // namespace splineloft::ui
