// What the program remembers from one start to the next, and what outlives a document: how one
// looks at documents, not which. Kept as JSON; which file that is, the program around it knows.
#pragma once

#include "core/formats/result.h"
#include "ui/session.h"

#include <string>
#include <string_view>

namespace splineloft::ui {

/// Copies what is remembered of a view, and nothing else.
void keepRemembered(const View& from, View& to);

/// The settings of a session as the text of a file.
std::string settingsText(const Session& session);

/// Gives a session the settings that a text describes. What the text does not mention stays, and
/// what this version does not know is passed over. A text that is damaged changes nothing, and the
/// refusal, which names no file, says where.
Result<Done> applySettings(Session& session, std::string_view text);

} // namespace splineloft::ui
