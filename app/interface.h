// Dear ImGui, started for as long as someone needs it.
#pragma once

#include "app/fonts.h"
#include "app/renderer.h"
#include "ui/frame.h"

namespace splineloft::app {

/// The interface and the renderer that draws it, started and ended in the right order. Needs a
/// current OpenGL context. There can be one at a time.
class Interface {
  public:
    Interface() : fonts_(findFonts()) {}

    /// Makes the fonts fit the scale of `screen`; costs nothing while it stays the same.
    void fit(const ui::Screen& screen) {
        if (screen.scale != scale_) {
            scale_ = screen.scale;
            ui::loadFonts(fonts_, screen);
            renderer_.uploadFonts();
        }
    }

    Renderer& renderer() { return renderer_; }

  private:
    struct Started {
        Started() { ui::startInterface(); }
        ~Started() { ui::stopInterface(); }
        Started(const Started&) = delete;
        Started& operator=(const Started&) = delete;
    };

    ui::Fonts fonts_;
    Started started_;
    Renderer renderer_;
    double scale_ = 0; // of the fonts that are loaded
};

} // namespace splineloft::app
