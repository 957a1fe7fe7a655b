// Where a sampled quantity of a motion is least and greatest, and which values of it to show.
#pragma once

#include "ui/motion_graph.h"

#include <optional>
#include <span>

namespace splineloft::ui {

/// The least and the greatest of all samples, each followed to its true place between its
/// neighbours by golden sections (Kiefer 1953).
std::optional<Extremes> extremesOf(std::span<const MotionRun> runs, Quantity quantity,
                                   const Motion& motion);

/// The values to be shown of a motion of so many seconds. What is ten times as great as it is for
/// nine tenths of the time is left out, so that the rest is not flattened.
ValueRange rangeOf(std::span<const MotionRun> runs, Quantity quantity, double duration);

} // namespace splineloft::ui
