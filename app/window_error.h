// What goes wrong when the program asks the machine for a screen.
#pragma once

#include <stdexcept>

namespace splineloft::app {

/// No window or no OpenGL to be had. The message is one line: the cause, then what would help.
class WindowError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

} // namespace splineloft::app
