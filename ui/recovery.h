// Work that an editor which died had in no file, as it is offered to the person.
#pragma once

#include "ui/canvas/thumbnail.h"
#include "ui/log.h"

#include <string>

namespace splineloft::ui {

struct UnsavedWork {
    std::string id;
    std::string path; ///< of the document's file; empty where it had none yet
    WallTime time;    ///< when it was kept
    std::size_t curves = 0, points = 0;
    Thumbnail thumbnail;
};

} // namespace splineloft::ui
