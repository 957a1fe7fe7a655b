// Dear ImGui with our fonts, started for as long as someone needs it.
#pragma once

#include "app/fonts.h"
#include "ui/frame.h"

#include <future>

namespace splineloft::app {

/// The interface without what draws it: a Renderer, which must begin after this and end before it.
/// Needs no OpenGL. There can be one at a time.
class Interface {
  public:
    /// Loads the fonts for the scale of `expected` while the caller goes on: finding and drawing
    /// their letters takes a fifth of the time to the first frame. Nobody else may use Dear ImGui
    /// before `fit`.
    explicit Interface(const ui::Screen& expected);
    ~Interface();
    Interface(const Interface&) = delete;
    Interface& operator=(const Interface&) = delete;

    /// Makes the fonts fit the scale of `screen`; costs nothing while it stays the same. Whether
    /// they are others than before: then the renderer must upload them. Throws WindowError when
    /// there are none to load.
    bool fit(const ui::Screen& screen);

  private:
    std::future<ui::Fonts> loading_; ///< of the first fonts; not valid once they are here
    ui::Fonts fonts_;
    double scale_; ///< of the fonts that are loaded, or being so
};

} // namespace splineloft::app
