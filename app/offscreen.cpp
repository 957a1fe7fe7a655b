#include "app/offscreen.h"

#include "app/gl.h"
#include "app/interface.h"
#include "app/window.h"

#include <glad/gl.h>

#ifdef SPLINELOFT_HAVE_EGL
#define EGL_NO_X11 // its headers name half the alphabet
#include <EGL/egl.h>
#include <EGL/eglext.h>
#endif

#include <array>

namespace splineloft::app {

struct OffscreenContext::Context {
    Context() = default;
    virtual ~Context() = default;
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;
};

namespace {

// Panels settle within this many frames: the first ones measure what the next ones place.
constexpr int settlingFrames = 4;
constexpr double frameSeconds = 1.0 / 60.0;

class HiddenWindow : public OffscreenContext::Context {
    Toolkit toolkit_;
    ui::InputQueue unheard_;
    Window window_{toolkit_, WindowOptions{64, 64, "Splineloft", false}, unheard_};
};

#ifdef SPLINELOFT_HAVE_EGL

// A context with no surface at all: it only ever draws into framebuffers of its own.
class EglContext : public OffscreenContext::Context {
  public:
    explicit EglContext(EGLDisplay display) : display_(display) {
        if (display_ == EGL_NO_DISPLAY || eglInitialize(display_, nullptr, nullptr) != EGL_TRUE) {
            throw WindowError("EGL cannot be started");
        }
        if (!makeContext()) {
            eglTerminate(display_);
            throw WindowError("EGL offers no OpenGL 3.3");
        }
    }

    ~EglContext() override {
        eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        eglDestroyContext(display_, context_);
        eglTerminate(display_);
    }

  private:
    bool makeContext() {
        constexpr std::array<EGLint, 5> wanted{EGL_SURFACE_TYPE, EGL_PBUFFER_BIT,
                                               EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
        constexpr std::array<EGLint, 7> core{EGL_CONTEXT_MAJOR_VERSION,
                                             3,
                                             EGL_CONTEXT_MINOR_VERSION,
                                             3,
                                             EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                             EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                             EGL_NONE};
        EGLConfig config = nullptr;
        EGLint found = 0;
        eglBindAPI(EGL_OPENGL_API);
        eglChooseConfig(display_, wanted.data(), &config, 1, &found);
        if (found == 0) {
            return false;
        }
        context_ = eglCreateContext(display_, config, EGL_NO_CONTEXT, core.data());
        return context_ != EGL_NO_CONTEXT &&
               eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) == EGL_TRUE;
    }

    EGLDisplay display_;
    EGLContext context_ = EGL_NO_CONTEXT;
};

std::unique_ptr<OffscreenContext::Context> withoutDisplay() {
    try {
        auto context = std::make_unique<EglContext>(
            eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr));
        gl::loadFunctions(eglGetProcAddress);
        return context;
    } catch (const WindowError&) {
        return nullptr; // another driver than Mesa: a hidden window may still do
    }
}

#else

std::unique_ptr<OffscreenContext::Context> withoutDisplay() {
    return nullptr;
}

#endif

} // namespace

OffscreenContext::OffscreenContext() : context_(withoutDisplay()) {
    if (!context_) {
        context_ = std::make_unique<HiddenWindow>();
    }
}

OffscreenContext::~OffscreenContext() = default;

Image drawOffscreen(Renderer& renderer, const ui::FrameResult& frame, const ui::Screen& screen) {
    const gl::Framebuffer framebuffer(screen.width, screen.height);
    framebuffer.bind();
    renderer.draw(frame, screen);
    return readPixels(screen.width, screen.height);
}

Image screenshot(ui::Session& session, const ui::Screen& screen) {
    Interface interface(ui::scaled(screen, session.view));
    const OffscreenContext context;
    Renderer renderer;
    interface.fit(ui::scaled(screen, session.view));
    renderer.uploadFonts();
    auto frame = ui::runFrame(session, screen, {}, frameSeconds);
    for (int settled = 1; settled < settlingFrames; ++settled) {
        frame = ui::runFrame(session, screen, {}, frameSeconds);
    }
    return drawOffscreen(renderer, frame, screen);
}

} // namespace splineloft::app
