// What goes on around the frames: the disk, and other programs that were asked something.
#pragma once

#include "ui/frame.h"
#include "ui/session.h"

namespace splineloft::app {

class Attendant {
  public:
    virtual ~Attendant() = default;
    /// Carries out what the session asks of the program after a frame; false ends the program.
    virtual bool afterFrame(ui::Session& session, const ui::Screen& screen) = 0;
    /// Does what has become due meanwhile. Whether that leaves something new to show.
    virtual bool attend(ui::Session& session) = 0;
    /// Seconds until there will be something to attend to; infinite while there is nothing.
    virtual double patience() const = 0;
};

} // namespace splineloft::app
