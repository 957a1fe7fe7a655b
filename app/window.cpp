#include "app/window.h"

#include "app/gl.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <optional>
#include <utility>

namespace splineloft::app {

namespace {

// Below these the panels would have no room; design pixels.
constexpr int leastWidth = 720;
constexpr int leastHeight = 480;

// What the toolkit says of its last failure.
std::string toolkitFault() {
    const char* text = nullptr;
    glfwGetError(&text);
    return text != nullptr ? text : "no cause is given";
}

ui::Modifiers modifiersFrom(int mods) {
    return {(mods & GLFW_MOD_SHIFT) != 0, (mods & GLFW_MOD_CONTROL) != 0,
            (mods & GLFW_MOD_ALT) != 0};
}

// On X11 the modifiers that come with a modifier key are those from before it changed.
ui::Modifiers modifiersAfter(ui::Key key, bool down, int mods) {
    auto modifiers = modifiersFrom(mods);
    if (key == ui::Key::leftShift || key == ui::Key::rightShift) {
        modifiers.shift = down;
    }
    if (key == ui::Key::leftControl || key == ui::Key::rightControl) {
        modifiers.control = down;
    }
    if (key == ui::Key::leftAlt || key == ui::Key::rightAlt) {
        modifiers.alt = down;
    }
    return modifiers;
}

// GLFW names a key by its place on a US keyboard; a shortcut means the letter printed on it.
ui::Key keyFrom(int key, int scancode) {
    const auto printable = key >= GLFW_KEY_SPACE && key < GLFW_KEY_ESCAPE;
    const char* const name = printable ? glfwGetKeyName(key, scancode) : nullptr;
    if (name != nullptr && name[0] >= 'a' && name[0] <= 'z' && name[1] == '\0') {
        return static_cast<ui::Key>(name[0] - 'a' + GLFW_KEY_A);
    }
    return static_cast<ui::Key>(key);
}

std::optional<ui::Button> buttonFrom(int button) {
    switch (button) {
    case GLFW_MOUSE_BUTTON_LEFT: return ui::Button::left;
    case GLFW_MOUSE_BUTTON_RIGHT: return ui::Button::right;
    case GLFW_MOUSE_BUTTON_MIDDLE: return ui::Button::middle;
    default: return std::nullopt;
    }
}

int cursorShape(ui::PointerShape shape) {
    switch (shape) {
    case ui::PointerShape::hand: return GLFW_HAND_CURSOR;
    case ui::PointerShape::move:
#ifdef GLFW_RESIZE_ALL_CURSOR // from GLFW 3.4 on
        return GLFW_RESIZE_ALL_CURSOR;
#else
        return GLFW_HAND_CURSOR;
#endif
    case ui::PointerShape::cross: return GLFW_CROSSHAIR_CURSOR;
    case ui::PointerShape::text: return GLFW_IBEAM_CURSOR;
    case ui::PointerShape::resizeAcross: return GLFW_HRESIZE_CURSOR;
    case ui::PointerShape::resizeAlong: return GLFW_VRESIZE_CURSOR;
    case ui::PointerShape::arrow: break;
    }
    return GLFW_ARROW_CURSOR;
}

// The monitor that shows most of a rectangle; null where there is none at all.
GLFWmonitor* monitorUnder(int x, int y, int width, int height) {
    int count = 0;
    GLFWmonitor** const monitors = glfwGetMonitors(&count);
    GLFWmonitor* best = glfwGetPrimaryMonitor();
    long most = 0;
    for (int i = 0; i < count; ++i) {
        int left = 0, top = 0, across = 0, down = 0;
        glfwGetMonitorWorkarea(monitors[i], &left, &top, &across, &down);
        const long wide = std::min(x + width, left + across) - std::max(x, left);
        const long high = std::min(y + height, top + down) - std::max(y, top);
        if (wide > 0 && high > 0 && wide * high > most) {
            most = wide * high;
            best = monitors[i];
        }
    }
    return best;
}

void askForCoreContext(const WindowOptions& options) {
    glfwDefaultWindowHints();
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
    glfwWindowHint(GLFW_DEPTH_BITS, 0);
    glfwWindowHint(GLFW_STENCIL_BITS, 0);
    glfwWindowHint(GLFW_SAMPLES, 0); // the shaders soften every edge themselves
    glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
    glfwWindowHint(GLFW_VISIBLE, options.visible ? GLFW_TRUE : GLFW_FALSE);
    glfwWindowHintString(GLFW_X11_CLASS_NAME, "splineloft");
    glfwWindowHintString(GLFW_X11_INSTANCE_NAME, "splineloft");
}

} // namespace

struct Window::Listener {
    ui::InputQueue& queue;
    int buttonsHeld = 0; // one bit each
    bool damaged = false;

    static Listener& of(GLFWwindow* window) {
        return *static_cast<Listener*>(glfwGetWindowUserPointer(window));
    }

    static void pointerMoved(GLFWwindow* window, double x, double y) {
        int across = 0, down = 0, pixelsAcross = 0, pixelsDown = 0;
        glfwGetWindowSize(window, &across, &down);
        glfwGetFramebufferSize(window, &pixelsAcross, &pixelsDown);
        if (across > 0 && down > 0) {
            of(window).queue.push(
                ui::PointerMoved{x * pixelsAcross / across, y * pixelsDown / down});
        }
    }

    // Outside the window the pointer is over nothing, unless it drags something out of it.
    static void pointerEntered(GLFWwindow* window, int entered) {
        if (entered == GLFW_FALSE && of(window).buttonsHeld == 0) {
            of(window).queue.push(ui::PointerMoved{-1, -1});
        }
    }

    static void pointerButton(GLFWwindow* window, int button, int action, int mods) {
        const auto known = buttonFrom(button);
        if (!known) {
            return;
        }
        const auto bit = 1 << button;
        auto& self = of(window);
        self.buttonsHeld = action == GLFW_PRESS ? self.buttonsHeld | bit : self.buttonsHeld & ~bit;
        self.queue.push(ui::PointerButton{*known, action == GLFW_PRESS, modifiersFrom(mods)});
    }

    // GLFW tells no modifiers with the wheel, so the keys are asked.
    static void wheelTurned(GLFWwindow* window, double dx, double dy) {
        const auto held = [&](int left, int right) {
            return glfwGetKey(window, left) == GLFW_PRESS ||
                   glfwGetKey(window, right) == GLFW_PRESS;
        };
        const ui::Modifiers modifiers{held(GLFW_KEY_LEFT_SHIFT, GLFW_KEY_RIGHT_SHIFT),
                                      held(GLFW_KEY_LEFT_CONTROL, GLFW_KEY_RIGHT_CONTROL),
                                      held(GLFW_KEY_LEFT_ALT, GLFW_KEY_RIGHT_ALT)};
        of(window).queue.push(ui::WheelTurned{dx, dy, modifiers});
    }

    static void keyChanged(GLFWwindow* window, int key, int scancode, int action, int mods) {
        if (key == GLFW_KEY_UNKNOWN) {
            return;
        }
        const auto named = keyFrom(key, scancode);
        const auto down = action != GLFW_RELEASE;
        of(window).queue.push(
            ui::KeyChanged{named, down, action == GLFW_REPEAT, modifiersAfter(named, down, mods)});
    }

    static void textTyped(GLFWwindow* window, unsigned character) {
        of(window).queue.push(ui::TextTyped{static_cast<char32_t>(character)});
    }

    static void focusChanged(GLFWwindow* window, int focused) {
        of(window).queue.push(ui::FocusChanged{focused != GLFW_FALSE});
    }

    static void filesDropped(GLFWwindow* window, int count, const char** paths) {
        of(window).queue.push(ui::FilesDropped{{paths, paths + count}});
    }

    // Whether to close is not the window's to decide: there may be unsaved work.
    static void closeAsked(GLFWwindow* window) {
        glfwSetWindowShouldClose(window, GLFW_FALSE);
        of(window).queue.push(ui::CloseAsked{});
    }

    static void uncovered(GLFWwindow* window) { of(window).damaged = true; }

    static void resized(GLFWwindow* window, int, int) { of(window).damaged = true; }

    static void rescaled(GLFWwindow* window, float, float) { of(window).damaged = true; }

    void listenTo(GLFWwindow* window) {
        glfwSetWindowUserPointer(window, this);
        glfwSetCursorPosCallback(window, pointerMoved);
        glfwSetCursorEnterCallback(window, pointerEntered);
        glfwSetMouseButtonCallback(window, pointerButton);
        glfwSetScrollCallback(window, wheelTurned);
        glfwSetKeyCallback(window, keyChanged);
        glfwSetCharCallback(window, textTyped);
        glfwSetWindowFocusCallback(window, focusChanged);
        glfwSetDropCallback(window, filesDropped);
        glfwSetWindowCloseCallback(window, closeAsked);
        glfwSetWindowRefreshCallback(window, uncovered);
        glfwSetFramebufferSizeCallback(window, resized);
        glfwSetWindowContentScaleCallback(window, rescaled);
    }
};

Toolkit::Toolkit() {
    if (glfwInit() != GLFW_TRUE) {
        throw WindowError("no window can be opened: " + toolkitFault() +
                          " (start it in a graphical session; `splineloft screenshot` needs none)");
    }
}

Toolkit::~Toolkit() {
    glfwTerminate();
}

void Window::Closed::operator()(GLFWwindow* window) const {
    glfwDestroyWindow(window);
}

void Window::Closed::operator()(GLFWcursor* cursor) const {
    glfwDestroyCursor(cursor);
}

Window::Window(const Toolkit&, const WindowOptions& options, ui::InputQueue& queue)
    : listener_(new Listener{queue}), title_(options.title) {
    askForCoreContext(options);
    window_.reset(
        glfwCreateWindow(options.width, options.height, title_.c_str(), nullptr, nullptr));
    if (!window_) {
        throw WindowError("no OpenGL 3.3 to draw with: " + toolkitFault() +
                          " (install or update the graphics driver; Mesa's software driver will "
                          "do: libgl1-mesa-dri)");
    }
    glfwSetWindowSizeLimits(window_.get(), leastWidth, leastHeight, GLFW_DONT_CARE, GLFW_DONT_CARE);
    listener_->listenTo(window_.get());
    glfwMakeContextCurrent(window_.get());
    gl::loadFunctions(glfwGetProcAddress);
    glfwSwapInterval(1);
}

Window::~Window() = default;

ui::Screen Window::screen() const {
    ui::Screen screen;
    float across = 1, down = 1;
    glfwGetFramebufferSize(window_.get(), &screen.width, &screen.height);
    glfwGetWindowContentScale(window_.get(), &across, &down);
    screen.width = std::max(screen.width, 1); // 0 while the window is reduced to an icon
    screen.height = std::max(screen.height, 1);
    screen.scale = across > 0 ? static_cast<double>(across) : 1.0;
    return screen;
}

bool Window::takeDamage() {
    return std::exchange(listener_->damaged, false);
}

void Window::swapBuffers() {
    glfwSwapBuffers(window_.get());
}

void Window::setTitle(const std::string& title) {
    if (title != title_) {
        title_ = title;
        glfwSetWindowTitle(window_.get(), title_.c_str());
    }
}

void Window::setPointer(ui::PointerShape shape) {
    if (shape != pointer_) {
        pointer_ = shape;
        cursor_.reset(glfwCreateStandardCursor(cursorShape(shape)));
        glfwSetCursor(window_.get(), cursor_.get()); // none, where the system lacks it, is an arrow
    }
}

void Window::setFullScreen(bool full) {
    if (full == placeBefore_.has_value()) {
        return;
    }
    GLFWwindow* const window = window_.get();
    if (const auto place = std::exchange(placeBefore_, std::nullopt)) {
        glfwSetWindowMonitor(window, nullptr, place->x, place->y, place->width, place->height,
                             GLFW_DONT_CARE);
        return;
    }
    Place place;
    glfwGetWindowPos(window, &place.x, &place.y);
    glfwGetWindowSize(window, &place.width, &place.height);
    GLFWmonitor* const monitor = monitorUnder(place.x, place.y, place.width, place.height);
    if (const GLFWvidmode* const mode = monitor ? glfwGetVideoMode(monitor) : nullptr) {
        placeBefore_ = place;
        glfwSetWindowMonitor(window, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
    }
}

std::string Window::clipboard() const {
    const char* const text = glfwGetClipboardString(window_.get());
    return text != nullptr ? text : "";
}

void Window::setClipboard(const std::string& text) {
    glfwSetClipboardString(window_.get(), text.c_str());
}

void Window::pollEvents() {
    glfwPollEvents();
}

void Window::waitEvents() {
    glfwWaitEvents();
}

void Window::waitEvents(double seconds) {
    glfwWaitEventsTimeout(seconds);
}

void wakeWindow() {
    glfwPostEmptyEvent();
}

} // namespace splineloft::app
