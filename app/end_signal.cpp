#include "app/end_signal.h"

#include <cstdlib>
#include <utility>

namespace splineloft::app {

EndSignal::EndSignal(std::function<void()> wake) {
    sigemptyset(&awaited_);
    for (const int number : {SIGTERM, SIGINT, SIGHUP}) {
        sigaddset(&awaited_, number);
    }
    pthread_sigmask(SIG_BLOCK, &awaited_, &before_);
    listener_ = std::thread([this, wake = std::move(wake)] { listen(wake); });
}

EndSignal::~EndSignal() {
    over_ = true;
    pthread_kill(listener_.native_handle(), SIGTERM);
    listener_.join();
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
}

void EndSignal::listen(const std::function<void()>& wake) {
    int number = 0;
    while (sigwait(&awaited_, &number) == 0 && !over_) {
        if (come_.exchange(true)) {
            std::_Exit(128 + number); // as a shell reports a program that a signal has ended
        }
        wake();
    }
}

} // namespace splineloft::app
