// The track along which a parameter's value slides, in the inspector and at the point itself.
#pragma once

#include "core/spline/family.h"

namespace splineloft::ui {

/// Where a value lies along the track: 0 .. 1 for those worth sliding through.
double trackPosition(const Parameter& parameter, double value);

/// The value at a position of the track, with as few digits as a hand can set; the neutral value
/// holds those near it.
double valueOnTrack(const Parameter& parameter, double position);

} // namespace splineloft::ui
