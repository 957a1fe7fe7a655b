// Moving the cursor along the active curve, as time or a key does.
#pragma once

#include "ui/session.h"

namespace splineloft::ui {

/// Moves the cursor by a part of the whole way (1: all of it), even in what the view is set to, and
/// from the end on from the start. The active curve must have a piece.
void travel(Session& session, double part);

} // namespace splineloft::ui
