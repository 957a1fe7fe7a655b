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

/// Opens the first file that can be read and adds the curves of the others, naming those that
/// cannot. Returns the paths of those that could; where there are none, the document stays.
std::vector<std::string> openTogether(ui::Session& session, const ui::OpenFiles& request);

/// Saves the document. Whether that went well; if not, the file is as it was.
bool saveTo(ui::Session& session, const ui::SaveFile& request);

void exportSamples(ui::Session& session, const ui::ExportSamples& request);

} // namespace splineloft::app
