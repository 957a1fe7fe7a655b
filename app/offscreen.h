// Drawing without a window: for screenshots, for machines without a display, and for tests.
#pragma once

#include "app/image.h"
#include "app/renderer.h"
#include "ui/frame.h"

#include <memory>

namespace splineloft::app {

/// A current OpenGL 3.3 context that belongs to no window. Needs no display where the driver speaks
/// EGL (Mesa does, in software too); elsewhere it is that of a hidden window.
class OffscreenContext {
  public:
    /// Throws WindowError when neither can be had.
    OffscreenContext();
    ~OffscreenContext();
    OffscreenContext(const OffscreenContext&) = delete;
    OffscreenContext& operator=(const OffscreenContext&) = delete;

    struct Context; // however it was come by
  private:
    std::unique_ptr<Context> context_;
};

/// Draws one frame, with Dear ImGui's draw data if there is any, into a picture of the size of
/// `screen`. Needs a current context. Throws WindowError if the driver cannot draw one so large.
Image drawOffscreen(Renderer& renderer, const ui::FrameResult& frame, const ui::Screen& screen);

/// What the editor would show of `session` on a screen of that size and scale, with no window and
/// no input. Throws WindowError.
Image screenshot(ui::Session& session, const ui::Screen& screen);

} // namespace splineloft::app
