// What the program has said, for those who looked away from the status line.
#pragma once

#include <chrono>
#include <deque>
#include <string>

namespace splineloft::ui {

using WallTime = std::chrono::system_clock::time_point;

/// One thing that was said, perhaps several times in a row.
struct Message {
    WallTime time; ///< when it was said last
    std::string text;
    bool isProblem = false;
    int times = 1;
};

/// The latest messages, oldest first.
class Log {
  public:
    static constexpr std::size_t most = 200;

    void add(std::string text, bool isProblem);
    const std::deque<Message>& messages() const { return messages_; }
    /// All of them as text, one a line.
    std::string text() const;

  private:
    std::deque<Message> messages_;
};

/// "14:03:27", where the person is.
std::string timeOfDay(WallTime time);
/// "2024-02-29 14:03", where the person is.
std::string dateAndTime(WallTime time);

/// The message with its time, as one line.
std::string lineFor(const Message& message);

} // namespace splineloft::ui
