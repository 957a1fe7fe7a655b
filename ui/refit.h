// What the camera does when the window, its scale or its panels change.
#pragma once

#include "ui/session.h"

namespace splineloft::ui {

/// Takes over the scale and the canvas of this frame. The plane grows along with the scale;
/// before an audience, all that was seen stays seen instead.
void followScreen(Session& session, double scale, const ScreenRect& canvas);

/// Shows every visible curve, if that was asked for.
void fitIfAsked(Session& session);

} // namespace splineloft::ui
