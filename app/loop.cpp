#include "app/loop.h"

#include "app/imgui_versions.h"
#include "app/interface.h"
#include "app/moment.h"
#include "app/renderer.h"
#include "app/window.h"

#include <imgui.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <utility>

namespace splineloft::app {

namespace {

// Dear ImGui shows the whole effect of an event only some frames later.
constexpr int settlingFrames = 3;

// Frames start at least this far apart, in case nothing else (the monitor, by way of the driver)
// holds them back. A little less than a frame of a 60 Hz monitor, so as not to miss its next one.
constexpr Seconds shortestFrame{1.0 / 70.0};

// A text cursor blinks while one types: a frame so often shows it.
constexpr double blinkSeconds = 0.25;

// No time at all would stop Dear ImGui.
constexpr double shortestStep = 1e-6;

// When to run the next frame.
class Pace {
  public:
    // Returns when a frame is due, with the events up to then in the queue.
    void wait(Window& window, const ui::InputQueue& queue, ui::Session& session,
              Attendant& attendant) {
        if (queue.empty()) {
            hold(window);
        }
        noteNews(window, queue);
        bool blinks = false;
        while (left_ == 0 && !animating_ && !blinks) {
            blinks = ImGui::GetIO().WantTextInput;
            sleep(window, std::min(blinks ? blinkSeconds : never, attendant.patience()));
            if (attendant.attend(session)) {
                left_ = settlingFrames;
            }
            noteNews(window, queue);
        }
    }

    // Notes the start of a frame and returns the time since the start of the one before.
    double start() {
        const auto now = Clock::now();
        const auto step = started_ ? Seconds(now - *started_).count() : 0;
        started_ = now;
        return std::max(step, shortestStep);
    }

    void drawn(bool animating) {
        animating_ = animating;
        left_ = std::max(left_ - 1, 0);
    }

  private:
    void noteNews(Window& window, const ui::InputQueue& queue) {
        if (window.takeDamage() || !queue.empty()) {
            left_ = settlingFrames;
        }
    }

    void hold(Window& window) {
        window.pollEvents();
        for (auto left = remaining(); left > 0; left = remaining()) {
            window.waitEvents(left);
        }
    }

    static void sleep(Window& window, double longest) {
        if (std::isfinite(longest)) {
            window.waitEvents(std::max(longest, shortestStep));
        } else {
            window.waitEvents();
        }
    }

    double remaining() const {
        return started_ ? (shortestFrame - Seconds(Clock::now() - *started_)).count() : 0;
    }

    std::optional<Moment> started_; // the last frame, if there was one
    bool animating_ = false;
    int left_ = settlingFrames;
};

WindowOptions sizeWanted(const ui::Session& session) {
    WindowOptions options;
    options.width = static_cast<int>(std::lround(session.habits.windowWidth));
    options.height = static_cast<int>(std::lround(session.habits.windowHeight));
    return options;
}

} // namespace

void runEditor(ui::Session& session, Attendant& attendant) {
    const auto wanted = sizeWanted(session);
    const Toolkit toolkit; // before there is a second thread: it reads large files by letters
    Interface interface(ui::scaled({wanted.width, wanted.height, 1}, session.view));
    ui::InputQueue queue;
    Window window(toolkit, wanted, queue);
    Renderer renderer;
    Clipboard clipboard{window, {}};
    shareClipboard(clipboard);
    Pace pace;
    bool shown = false;
    while (true) {
        pace.wait(window, queue, session, attendant);
        const auto screen = window.screen();
        if (interface.fit(ui::scaled(screen, session.view))) {
            renderer.uploadFonts();
        }
        const auto frame = ui::runFrame(session, screen, queue.takeFrame(), pace.start());
        if (!attendant.afterFrame(session, screen)) {
            return;
        }
        window.setTitle(frame.title);
        window.setPointer(frame.pointer);
        window.setFullScreen(frame.fullScreen);
        if (!queue.empty()) {
            continue; // events that were caught up with are not worth showing one by one
        }
        if (!std::exchange(shown, true)) {
            renderer.drawPanels(frame, screen); // the curves come with the next frame
        } else {
            renderer.draw(frame, screen);
        }
        window.swapBuffers();
        pace.drawn(frame.animating);
    }
}

} // namespace splineloft::app
