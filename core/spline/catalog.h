// The one list of spline families, in the order in which they are shown.
#pragma once

#include "core/spline/family.h"

#include <span>
#include <string_view>

namespace splineloft {

/// Every family.
std::span<const Family> catalog();

/// The family of that id, or null.
const Family* findFamily(std::string_view id);

/// Name of a way of ending, as in files: "none", "open", "doubled", "reflected", "clamped".
std::string_view nameOf(Ends ends);

} // namespace splineloft
