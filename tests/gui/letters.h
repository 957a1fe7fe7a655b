// The letters that Dear ImGui has drawn in the last frame, found again in its lists of triangles.
#pragma once

#include "ui/drawing.h"

#include <string>
#include <vector>

namespace splineloft::ui {

/// One letter on the screen.
struct DrawnLetter {
    std::string window; ///< the window that it belongs to
    ScreenRect rect;    ///< its ink, framebuffer pixels
    ScreenRect clip;    ///< what of the screen could be drawn on
    char32_t sign = 0;  ///< 0 where only a part of a letter was drawn
};

/// All letters of the last frame. None for versions of Dear ImGui that keep their letters otherwise
/// (from 1.92 on).
std::vector<DrawnLetter> drawnLetters();

/// What of them cannot be read, in words: cut off at an edge that nobody can scroll to, or lying on
/// one another. Labels on canvas and plots have tests of their own.
std::vector<std::string> illegible(const std::vector<DrawnLetter>& letters);

} // namespace splineloft::ui
