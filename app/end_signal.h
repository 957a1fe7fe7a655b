// The system asks the program to end: at a logout, by `kill`, by Ctrl+C in the terminal it was
// started from.
#pragma once

#include <atomic>
#include <csignal>
#include <functional>
#include <thread>

namespace splineloft::app {

/// While it lives, SIGTERM, SIGINT and SIGHUP do not end the program but are noted here; a second
/// one ends it at once. To be made before there is another thread.
class EndSignal {
  public:
    /// `wake` is called from a thread of its own when the signal has come.
    explicit EndSignal(std::function<void()> wake);
    ~EndSignal();
    EndSignal(const EndSignal&) = delete;
    EndSignal& operator=(const EndSignal&) = delete;

    bool hasCome() const { return come_; }

  private:
    void listen(const std::function<void()>& wake);

    sigset_t awaited_{}, before_{};
    std::atomic<bool> come_ = false;
    std::atomic<bool> over_ = false; ///< nobody listens any more
    std::thread listener_;
};

} // namespace splineloft::app
