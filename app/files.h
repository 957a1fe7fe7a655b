// What the session asks of the disk: opening, saving, exporting. Whatever goes wrong comes back as
// a notice, with the document as it was.
#pragma once

#include "core/formats/result.h"
#include "ui/session.h"

#include <string>
#include <vector>

namespace splineloft::app {

/// A document that the program carries within itself, to begin with.
Document exampleDocument();

/// A session on the first file, with the curves of the others added to it; on the example where
/// there is none. A file that does not exist yet is begun; one that is refused is left alone.
Result<ui::Session> beginSession(const std::vector<std::string>& files);

/// Carries out all requests of the session. False: the program is to end.
bool carryOutRequests(ui::Session& session);

} // namespace splineloft::app
