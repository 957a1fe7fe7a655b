// One frame of the interface: events in, pictures and requests out. It knows no window and no GL;
// the program and the headless tests call it in the same way.
#pragma once

#include "ui/drawing.h"
#include "ui/input.h"
#include "ui/session.h"
#include "ui/stage.h"

#include <span>
#include <string>
#include <vector>

namespace splineloft::ui {

/// Files of the fonts (found by the program through fontconfig).
struct Fonts {
    std::string regular;
    std::string bold;
};

enum class PointerShape { arrow, hand, move, cross, text, resizeAcross, resizeAlong };

/// What the program must do after a frame.
struct FrameResult {
    std::vector<Picture> pictures; ///< to be drawn in this order, beneath the Dear ImGui draw data
    Colour background;             ///< of the window, where no picture is
    bool animating = false;        ///< draw another frame at once, without waiting for an event
    PointerShape pointer = PointerShape::arrow;
    std::string title;       ///< of the window
    bool fullScreen = false; ///< the window fills its monitor
};

/// Starts Dear ImGui for the interface: one context, our style, no files written.
void startInterface();
void stopInterface();

/// Loads the fonts for `screen.scale`; call before the first frame and whenever the scale that
/// `scaled` gives changes. The renderer must upload the font texture anew afterwards.
void loadFonts(const Fonts& fonts, const Screen& screen);

/// Runs one frame on a screen that has the scale of its monitor. Takes `events` in order, advances
/// animations by `seconds`, changes `session` (including its list of requests to the program), and
/// leaves Dear ImGui's draw data ready.
FrameResult runFrame(Session& session, const Screen& screen, std::span<const InputEvent> events,
                     double seconds);

} // namespace splineloft::ui
