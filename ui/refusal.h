// Why something was not possible, in the words of the window rather than those of a file.
#pragma once

#include "core/document/document.h"

#include <string>

namespace splineloft::ui {

/// "Set y of P₃ is not possible: y of P₃ is not a finite number; right would be: a finite number".
/// The problem's place is a JSON pointer into that document; `deed` may be empty.
std::string refusalOf(const std::string& deed, const Problem& problem, const Document& document);

} // namespace splineloft::ui
