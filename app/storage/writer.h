// Work on the disk beside the drawing: one task at a time, on a thread of its own.
#pragma once

#include "core/formats/result.h"

#include <chrono>
#include <exception>
#include <functional>
#include <future>
#include <optional>
#include <utility>

namespace splineloft::app {

/// Its destructor waits until the task is done.
class Writer {
  public:
    /// How often to ask whether a task is done, in seconds.
    static constexpr double askAgain = 0.05;

    bool busy() const { return task_.valid(); }

    /// Begins a task; there must be none. Whatever it throws becomes a refusal.
    void begin(std::function<Result<Done>()> task) {
        task_ = std::async(std::launch::async, [task = std::move(task)]() -> Result<Done> {
            try {
                return task();
            } catch (const std::exception& fault) {
                return Refusal{"", "", fault.what(), ""};
            }
        });
    }

    /// How the task ended, once, as soon as it has.
    std::optional<Result<Done>> outcome() {
        const bool done =
            busy() && task_.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
        return done ? std::optional(task_.get()) : std::nullopt;
    }

    void wait() const {
        if (busy()) {
            task_.wait();
        }
    }

  private:
    std::future<Result<Done>> task_;
};

} // namespace splineloft::app
