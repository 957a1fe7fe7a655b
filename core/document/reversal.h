// A curve run through backwards.
#pragma once

#include "core/document/document.h"

namespace splineloft {

/// The entry with its curve run through backwards, of the same shape where the family can draw it
/// backwards; the modes of its handles go along.
CurveEntry reversed(const CurveEntry& entry);

} // namespace splineloft
