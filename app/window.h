// The window on the screen. What happens to it is pushed into a queue and nothing else: its
// callbacks decide nothing.
#pragma once

#include "app/window_error.h"
#include "ui/frame.h"
#include "ui/input.h"

#include <memory>
#include <optional>
#include <string>

struct GLFWwindow;
struct GLFWcursor;

namespace splineloft::app {

/// How a window starts.
struct WindowOptions {
    int width = 1280, height = 800; ///< design pixels
    std::string title = "Splineloft";
    bool visible = true; ///< a hidden one still has an OpenGL context
};

/// What windows are made with. One at a time, from before the first window until after the last.
class Toolkit {
  public:
    /// Throws WindowError when there is no display.
    Toolkit();
    ~Toolkit();
    Toolkit(const Toolkit&) = delete;
    Toolkit& operator=(const Toolkit&) = delete;
};

/// A window with a current OpenGL 3.3 core context, its functions loaded.
class Window {
  public:
    /// Opens the window, which pushes its events into `queue` for as long as it lives. Throws
    /// WindowError when there is no OpenGL 3.3.
    Window(const Toolkit&, const WindowOptions& options, ui::InputQueue& queue);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    /// Size in framebuffer pixels (each side at least 1) and scale, as they are now.
    ui::Screen screen() const;

    /// Whether the window must be drawn again although no event says so: it was resized, or
    /// uncovered. Asking settles the matter.
    bool takeDamage();

    /// Shows what was drawn; waits for the monitor where the driver does.
    void swapBuffers();

    void setTitle(const std::string& title);
    void setPointer(ui::PointerShape shape);
    /// Fills the monitor that shows most of the window, or goes back to the place and size from
    /// before. Nothing where that is how it is already.
    void setFullScreen(bool full);

    std::string clipboard() const;
    void setClipboard(const std::string& text);

    /// Takes the events that have arrived.
    void pollEvents();
    /// Sleeps until something happens.
    void waitEvents();
    /// Sleeps until something happens, `seconds` (> 0) at most.
    void waitEvents(double seconds);

  private:
    struct Listener; // what the callbacks need
    struct Closed {
        void operator()(GLFWwindow* window) const;
        void operator()(GLFWcursor* cursor) const;
    };

    std::unique_ptr<Listener> listener_;
    std::unique_ptr<GLFWwindow, Closed> window_;
    std::unique_ptr<GLFWcursor, Closed> cursor_;
    struct Place {
        int x = 0, y = 0, width = 0, height = 0; // screen coordinates
    };
    std::optional<Place> placeBefore_; // of a window that fills its monitor
    std::string title_;
    ui::PointerShape pointer_ = ui::PointerShape::arrow;
};

/// Ends the sleep of the window, if there is one. From any thread.
void wakeWindow();

} // namespace splineloft::app
