// What the program does differently for different versions of Dear ImGui (1.86 to 1.92).
#pragma once

#include <string>

namespace splineloft::app {

class Window;

/// Hands the font atlas to OpenGL, in place of an older one if there was one.
void renewFontTexture();

/// Text on its way from the window's clipboard to Dear ImGui, which wants it kept for a while.
struct Clipboard {
    Window& window;
    std::string text;
};

/// Lets Dear ImGui copy and paste through the window. The clipboard must outlive its context.
void shareClipboard(Clipboard& clipboard);

} // namespace splineloft::app
