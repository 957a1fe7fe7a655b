// One step of each gesture: what the next event makes of it. And what the steps have in common.
#pragma once

#include "ui/canvas/gesture.h"

namespace splineloft::ui {

using Kind = PointerEvent::Kind;

Reaction step(const Idle& idle, const View& view, const PointerEvent& event, const Situation& s);
Reaction step(const DraggingPoints& drag, const View& view, const PointerEvent& event,
              const Situation& s);
Reaction step(const Boxing& box, const View& view, const PointerEvent& event, const Situation& s);
Reaction step(const Panning& pan, const View& view, const PointerEvent& event, const Situation& s);
Reaction step(const SlidingCursor& sliding, const View& view, const PointerEvent& event,
              const Situation& s);
Reaction step(const PlacingPoint& placing, const View& view, const PointerEvent& event,
              const Situation& s);

Reaction step(const Transforming& pulling, const View& view, const PointerEvent& event,
              const Situation& s);
Reaction step(const SlidingStem& sliding, const View& view, const PointerEvent& event,
              const Situation& s);

/// What a press of the pen begins.
Reaction pressWithPen(const View& view, const PointerEvent& event, const Situation& s);

/// Nothing happens.
Reaction stay(const Gesture& gesture, const View& view);

/// Whether two places are farther apart than a hand trembles in a click.
bool beyondClick(ScreenPoint a, ScreenPoint b, const Situation& situation);

/// Whether the event ends a gesture and undoes it: Escape, a lost focus, the right button.
bool givesUp(const PointerEvent& event);
/// Whether it ends a gesture that the left button began.
bool letsGo(const PointerEvent& event);

} // namespace splineloft::ui
