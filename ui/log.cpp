#include "ui/log.h"

#include <array>
#include <ctime>
#include <utility>

namespace splineloft::ui {
namespace {

std::string local(WallTime time, const char* format) {
    const std::time_t seconds = std::chrono::system_clock::to_time_t(time);
    std::tm parts{};
    ::localtime_r(&seconds, &parts);
    std::array<char, 32> text{};
    return {text.data(), std::strftime(text.data(), text.size(), format, &parts)};
}

} // namespace

void Log::add(std::string text, bool isProblem) {
    const auto now = std::chrono::system_clock::now();
    if (!messages_.empty() && messages_.back().text == text) {
        messages_.back().time = now;
        ++messages_.back().times;
        return;
    }
    messages_.push_back({now, std::move(text), isProblem});
    if (messages_.size() > most) {
        messages_.pop_front();
    }
}

std::string Log::text() const {
    std::string all;
    for (const auto& message : messages_) {
        all += lineFor(message) + '\n';
    }
    return all;
}

std::string timeOfDay(WallTime time) {
    return local(time, "%H:%M:%S");
}

std::string dateAndTime(WallTime time) {
    return local(time, "%Y-%m-%d %H:%M");
}

std::string lineFor(const Message& message) {
    return timeOfDay(message.time) + "  " + (message.isProblem ? "! " : "") + message.text +
           (message.times > 1 ? "  (" + std::to_string(message.times) + " times)" : "");
}

} // namespace splineloft::ui
