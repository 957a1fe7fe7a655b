// An edit on its way to the document.
#pragma once

#include "core/document/document.h"

#include <string>

namespace splineloft::ui {

/// Whether a hand is still moving.
enum class Phase {
    preview, ///< show it, settle nothing
    commit,  ///< done: one undo step
    cancel   ///< never mind
};

/// A document to become the present one, and what the person did, as the undo menu names it.
struct Edit {
    Document next;
    Phase phase = Phase::commit;
    std::string label;
};

} // namespace splineloft::ui
