// Time as it passes, for what is due later.
#pragma once

#include <chrono>
#include <limits>

namespace splineloft::app {

using Clock = std::chrono::steady_clock;
using Moment = Clock::time_point;
using Seconds = std::chrono::duration<double>;

inline constexpr double never = std::numeric_limits<double>::infinity(); // seconds

/// Seconds from one moment to another, 0 where that is over.
inline double secondsUntil(Moment then, Moment now) {
    return then > now ? Seconds(then - now).count() : 0;
}

/// A moment so many seconds later.
inline Moment after(Moment now, double seconds) {
    return now + std::chrono::duration_cast<Clock::duration>(Seconds(seconds));
}

} // namespace splineloft::app
